// SPDX-License-Identifier: MIT
//
// Writes what needs no build:  write_package TEMPLATES FOLDER
//
// FOLDER/shaders                           files to paste: see paste.hpp
// FOLDER/umbrage.mjs, umbrage.d.mts        the npm package's module: TEMPLATES/umbrage.mjs.in and the texts
// FOLDER/umbrage.cjs, umbrage.d.cts        the same for Node's require
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <stdexcept>
#include <vector>

#include "paste.hpp"

namespace package {
namespace {

namespace fs = std::filesystem;
using glsl::snippet;

/// FOLDER/NAME.in with each @key@ replaced.
std::string filled(const fs::path& path, std::initializer_list<std::pair<std::string_view, std::string>> values) {
    std::ifstream file(path);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.empty()) throw std::runtime_error("cannot read " + path.string());
    for (const auto& [key, value] : values)
        for (auto at = text.find(key); at != text.npos; at = text.find(key, at + value.size()))
            text.replace(at, key.size(), value);
    return text;
}

bool is_variant(const snippet& s) { return std::ranges::find(glsl::hooks::all, &s) != std::end(glsl::hooks::all); }

/// What the module calls a snippet: its name, or of a hook's variant which one it is.
std::string id(const snippet& s) { return is_variant(s) ? "hooks/" + std::string(s.summary) : std::string(s.name); }

std::string list(std::span<const snippet* const> snippets) {
    std::string out = "[";
    for (const snippet* s : snippets) out += (out.size() > 1 ? ", " : "") + literal(id(*s));
    return out + ']';
}

std::string_view role(glsl::hook h) {
    switch (h) {
        case glsl::hook::none: return "none";
        case glsl::hook::cleared_depth: return "cleared_depth";
        case glsl::hook::map_covers: return "map_covers";
        case glsl::hook::beyond_far_plane: return "beyond_far_plane";
        case glsl::hook::within_far_plane: return "within_far_plane";
        case glsl::hook::compare: return "compare";
        case glsl::hook::texel: return "texel";
        case glsl::hook::fetch_depth: return "fetch_depth";
        case glsl::hook::lit: return "lit";
        case glsl::hook::lit_2x2: return "lit_2x2";
        case glsl::hook::gather_lit: return "gather_lit";
        case glsl::hook::lit_filtered: return "lit_filtered";
        case glsl::hook::lit_at: return "lit_at";
        case glsl::hook::depth_at: return "depth_at";
        case glsl::hook::chosen: return "chosen";
    }
    return "";
}

std::string row(const snippet& s) {
    const glsl::tier exactness = is_variant(s) ? s.exactness : glsl::exactness({s});
    return "    [" + literal(id(s)) + ", " + literal(s.name) + ", " + literal(s.summary) + ", \"" +
           "abc"[static_cast<int>(exactness)] + "\", " + std::to_string(s.operations) + ", " +
           (s.within > 0.0f ? "1 / " + std::to_string(static_cast<int>(1.0f / s.within)) : "0") + ", " +
           (s.as_written ? "true" : "false") + ", " + literal(directive(s.lowest)) + ", " + literal(role(s.role)) +
           ", " + (s.scaled ? "true" : "false") + ", " + list(s.needs) + "],\n";
}

std::string words(const glsl::detail::texture_words& w) {
    std::string out = "{ ";
    const auto add = [&](std::string_view name, std::string_view value) {
        out += std::string(out.size() > 2 ? ", " : "") + std::string(name) + ": " + literal(value);
    };
    add("parameters", w.parameters);
    add("arguments", w.arguments);
    add("texel", w.texel);
    add("sampled", w.sampled);
    add("lit", w.lit);
    add("gather_red", w.gather_red);
    add("gather_green", w.gather_green);
    add("gather_lit", w.gather_lit);
    add("lit_filtered", w.lit_filtered);
    add("size", w.size);
    add("sampler", w.sampler);
    add("sampler_argument", w.sampler_argument);
    return out + ", needs: " + list(w.needs) + " }";
}

template <class Use>
void for_each_snippet(const Use& use) {
    for (const snippet* s : glsl::registry()) use(*s);
    for (const snippet* s : glsl::hooks::all) use(*s);
}

std::string languages_of_module() {
    std::string out = "const languages = {\n";
    for (const shader_language& l : languages) {
        out += "    " + std::string(l.name) + ": {\n";
        out += "        prelude: " + literal(l.words->prelude) + ",\n";
        out += "        receiver_plane: " + literal(l.words->receiver_plane) + ",\n";
        out += "        may_reorder: " + literal(l.words->may_reorder) + ",\n";
        out += std::string("        preprocessor: ") + (l.words->preprocessor ? "true" : "false") + ",\n";
        out += "        textures: {\n";
        for (const named_texture& t : textures)
            out += "            " + std::string(t.name) + ": " + words(l.words->texture(t.kind)) + ",\n";
        out += "        },\n        texts: {\n";
        for_each_snippet(
            [&](const snippet& s) { out += "            " + literal(id(s)) + ": `" + l.words->translate(s) + "`,\n"; });
        out += "        },\n    },\n";
    }
    return out + "};\n";
}

std::string encoding_of_module(const auto& encoding) {
    using type = std::decay_t<decltype(encoding)>;
    const glsl::binding map = glsl::stored_as(encoding);
    std::string cleared;
    for (const std::string& channel : cleared_channels(encoding)) cleared += (cleared.empty() ? "" : ", ") + channel;
    return "{ direction: " + literal(map.direction == umbrage::depth_direction::forward ? "forward" : "reversed") +
           ", depth: " + literal(map.depth) + ", channels: " + std::to_string(map.channels) + ", needs: [" +
           (map.needs.empty() ? "" : "snippets." + std::string(map.needs.front().name)) +
           "],\n        writer: snippets." + std::string(type::writer->name) +
           ", writes: " + literal(writes(encoding)) + ", format: " + literal(type::target::format) +
           (type::writes == umbrage::store_format::integers
                ? ", to_unorm: snippets." + std::string(type::target::to_unorm->name)
                : "") +
           ", cleared: [" + cleared + "]";
}

std::string encodings_of_module() {
    std::string out = "export const encodings = {\n";
    umbrage::for_each_encoding([&](auto encoding) {
        out += "    " + std::string(encoding.name) + ": " + encoding_of_module(encoding);
        encoding = {.direction = umbrage::depth_direction::reversed};
        out += ",\n        reversed: " + encoding_of_module(encoding) + " } },\n";
    });
    return out + "};\n";
}

std::string names_of_encodings() {
    std::string out;
    umbrage::for_each_encoding(
        [&](const auto& e) { out += (out.empty() ? "'" : " | '") + std::string(e.name) + '\''; });
    return out;
}

std::string module_data() {
    const std::string keys = "id, name, summary, exactness, operations, within, as_written, lowest, role, scaled";
    std::string rows, names, versions, exported;
    for_each_snippet([&](const snippet& s) { rows += row(s); });
    for (const snippet* s : glsl::registry()) names += (names.empty() ? "" : ", ") + std::string(s->name);
    for (const glsl::version v : glsl::versions)
        if (v != glsl::version::vulkan) versions += (versions.empty() ? "" : ", ") + literal(directive(v));
    for (const shader_language& l : languages)
        exported += "export const " + std::string(l.name) + " = in_language('" + std::string(l.name) + "');\n";
    return "export const versions = [" + versions + "];\n\n" + languages_of_module() + "\n// " + keys +
           ", needs\nconst rows = [\n" + rows + "];\nconst all = new Map(rows.map(([" + keys + "]) =>\n    [id, { " +
           keys +
           ", needs: [] }]));\n"
           "for (const [id, , , , , , , , , , needs] of rows) all.get(id).needs.push(...needs.map(need => "
           "all.get(need)));\n"
           "const part = variants => Object.fromEntries([...all]\n"
           "    .filter(([id]) => id.startsWith('hooks/') === variants).map(([id, s]) => [id.replace('hooks/', ''), "
           "s]));\n"
           "const hooks = part(true);\nexport const snippets = part(false);\n" +
           encodings_of_module() + exported + "export const { " + names + " } = snippets;";
}

/// The module as Node's require takes it: exports at the end.
std::string as_commonjs(std::string text) {
    std::string names;
    const std::string_view keyword = "\nexport ";
    for (auto at = text.find(keyword); at != text.npos; at = text.find(keyword, at)) {
        text.erase(at + 1, keyword.size() - 1);
        const auto name = text.find(' ', at) + 1;
        const bool several = text[name] == '{';
        const auto end = text.find_first_of(several ? "}" : " (", name);
        names += (names.empty() ? "" : ", ") +
                 (several ? text.substr(name + 2, end - name - 3) : text.substr(name, end - name));
    }
    return text + "\nmodule.exports = { " + names + " };\n";
}

std::string module_names() {
    std::string out;
    for (const shader_language& l : languages)
        out += "export const " + std::string(l.name) + (l.name == "glsl" ? ": VersionedLanguage;\n" : ": Language;\n");
    for (const snippet* s : glsl::registry())
        out += "/** " + std::string(s->summary) + " */\nexport const " + std::string(s->name) + ": Snippet;\n";
    return out;
}

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const std::filesystem::path templates = argv[1], folder = argv[2];
        std::filesystem::remove_all(folder / "shaders");  // those of snippets that are no more, too
        package::write_shaders(folder / "shaders", package::copyright(templates / "../../LICENSE"));
        const std::string module = package::filled(
            templates / "umbrage.mjs.in", {{"@version@", package::version}, {"@data@", package::module_data()}});
        const std::string types =
            package::filled(templates / "umbrage.d.mts.in", {{"@version@", package::version},
                                                             {"@encodings@", package::names_of_encodings()},
                                                             {"@names@", package::module_names()}});
        package::write(folder / "umbrage.mjs", module);
        package::write(folder / "umbrage.cjs", package::as_commonjs(module));
        package::write(folder / "umbrage.d.mts", types);
        package::write(folder / "umbrage.d.cts", types);
    } catch (const std::exception& error) {
        std::cerr << "write_package: " << error.what() << '\n';
        return 1;
    }
}
