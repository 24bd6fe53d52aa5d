// SPDX-License-Identifier: MIT
//
// Files to paste, each with a head that says what its map must be:
//
// LANGUAGE/NAME.EXTENSION          a snippet with all it needs; of WGSL, which has no preprocessor, one function
// wgsl_joined/NAME.wgsl            with all it needs
// LANGUAGE/NAME_shadow.EXTENSION   the same for a comparison sampler; of WGSL in wgsl_joined
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/filter/prefiltered/prefilters.hpp>

#include "languages.hpp"

namespace package {

namespace fs = std::filesystem;
using glsl::snippet;

inline const std::string version = std::to_string(UMBRAGE_VERSION_MAJOR) + '.' + std::to_string(UMBRAGE_VERSION_MINOR) +
                                   '.' + std::to_string(UMBRAGE_VERSION_PATCH);

inline void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    if (!(file << text)) throw std::runtime_error("cannot write " + path.string());
}

/// The line of LICENSE that says whose it is.
inline std::string copyright(const fs::path& license) {
    std::ifstream file(license);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("Copyright")) return line;
    throw std::runtime_error("no copyright in " + license.string());
}

/// A line of comment, broken into several of at most 118 columns.
inline std::string comment(std::string text) {
    std::string out = "// ";
    for (std::size_t room = 115; text.size() > room; room = 113) {
        const auto end = text.rfind(' ', room);
        out += text.substr(0, end) + "\n//   ";
        text.erase(0, end + 1);
    }
    return out + text + '\n';
}

struct option {
    std::string_view field, meaning;
    glsl::hook first, last;  ///< the hooks of whose text it changes something
};
inline constexpr option options[]{
    {"texture", "array, atlas, cube, shadow, ...; parameters, arguments and texel take any other", glsl::hook::texel,
     glsl::hook::depth_at},
    {"depth", "depth of a texel's value, in place of .x: for packed depths", glsl::hook::fetch_depth,
     glsl::hook::depth_at},
    {"outside", "clamped: outside the map the nearest texel inside counts; without it all is lit there",
     glsl::hook::fetch_depth, glsl::hook::depth_at},
    {"outside", "clamped: outside the map the nearest texel inside counts; without it all is lit there",
     glsl::hook::map_covers, glsl::hook::map_covers},
    {"compare", "one comparison, in place of receiver <= stored", glsl::hook::compare, glsl::hook::compare},
    {"direction", "reversed: depth is 1.0 at the near plane and 0.0 at the far plane", glsl::hook::cleared_depth,
     glsl::hook::compare}};

/// Options of bind() that change the texts of items.
inline std::string options_of(const std::vector<glsl::bound>& items) {
    std::string out;
    for (const option& o : options)
        for (const glsl::bound& item : items) {
            const bool has_it =
                (o.field != "depth" && o.field != "compare") || !glsl::detail::compares(item.map.texture);
            const std::string line = "//   " + std::string(o.field) + std::string(11 - o.field.size(), ' ');
            if (has_it && glsl::detail::calls(item.what, o.first, o.last) && out.find(line) == out.npos)
                out += line + std::string(o.meaning) + '\n';
        }
    return out.empty()
               ? out
               : "// For other maps, bind() of the library or of its npm package prints this text, with\n" + out;
}

inline const std::string target = " not sRGB, no blending, one sample. Clear to ";

/// The render targets of the encodings and prefiltered maps that a snippet writes or reads.
inline std::string targets_of(const snippet& s) {
    std::string out;
    umbrage::for_each_encoding([&](auto e) {
        using type = decltype(e);
        if constexpr (type::writes != umbrage::store_format::depth) {
            if (s != *type::writer && s != *type::reader) return;
            using kept = typename type::target;
            constexpr int most = (1 << kept::bits) - 1;
            const auto cleared = [&] {
                std::string all;
                const glm::vec4 values = kept::load(e.cleared());
                for (int c = 0; c < kept::channels; ++c)
                    all += (c > 0 ? ", " : "(") + std::to_string(std::lround(values[c] * most));
                return all + ") / " + std::to_string(most);
            };
            std::string line = "Render target of " + std::string(type::name) + ": " + std::string(kept::format) +
                               " UNORM," + target + cleared();
            e = {.direction = umbrage::depth_direction::reversed};
            line += ", with reversed depth to " + cleared() + ". Write ";
            const bool integers = type::writes == umbrage::store_format::integers;
            out += comment(line + (integers ? "umbrage_" + std::string(kept::to_unorm->name) + " of " : "") +
                           "umbrage_" + std::string(type::writer->name) + ".");
        }
    });
    umbrage::prefilters::all::for_each([&](const auto& p) {
        using type = std::decay_t<decltype(p)>;
        if (s != *type::writer && s != *type::snippet) return;
        const bool unorm = type::name == std::string_view("msm_unorm16");
        out += comment("Render target of " + std::string(type::name) + ": " + format_of_moments<type>() +
                       (unorm ? " UNORM," : ",") + target + "umbrage_" + std::string(type::writer->name) +
                       (unorm ? " of umbrage_encode_msm" : "") + " of the far plane's depth.");
    });
    return out;
}

/// Filters with a file for comparison samplers, which engines have.
inline constexpr std::array compared_by_samplers{&glsl::hard,
                                                 &glsl::pcf_2x2,
                                                 &glsl::box,
                                                 &glsl::tent<2>,
                                                 &glsl::tent<3>,
                                                 &glsl::castano<5>,
                                                 &glsl::castano<7>,
                                                 &glsl::disc<16>,
                                                 &glsl::pcf_2x2_hardware,
                                                 &glsl::window_hardware<3>,
                                                 &glsl::window_hardware<5>,
                                                 &glsl::window_hardware<7>,
                                                 &glsl::disc_hardware<16>};

/// Map that a snippet reads.
inline std::string map_of(const shader_language& l, const glsl::bound& item) {
    if (!glsl::detail::reads_map(item.what)) return "";
    const glsl::texture kind = item.map.texture;
    std::string parameters(l.words->texture(kind).parameters);
    for (const std::string_view word : {"UMBRAGE_HIGHP ", "metal::"})
        for (auto at = parameters.find(word); at != parameters.npos; at = parameters.find(word))
            parameters.erase(at, word.size());
    const std::string map = "Map: `" + parameters + "`, ";
    if (kind == glsl::texture::shadow) {
        const bool linear = item.what.name.find("hardware") != item.what.name.npos;
        return comment(map + "a depth texture. Its sampler passes receiver <= depth, clamps to the edge and filters " +
                       (linear ? "linearly." : "nearest.")) +
               comment("Render target of the map: depth attachment, one sample. Clear to 1.0.");
    }
    if (!glsl::detail::calls(item.what, glsl::hook::fetch_depth, glsl::hook::depth_at))
        return comment(map + "texels of the kind that the function's comment names, read unfiltered.");
    const bool has_file = std::ranges::count(compared_by_samplers, item.what.name, &snippet::name) > 0;
    const std::string file = " For a comparison sampler: " + std::string(item.what.name) + "_shadow.";
    return comment(map + "a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered." +
                   (has_file ? file : "")) +
           comment("Render target of the map: depth attachment, or R32F," + target +
                   "1.0, with reversed depth to 0.0.");
}

/// Text with a head in place of its first line.
inline std::string with_head(const shader_language& l, const std::string& copyright, const std::string& name,
                             std::string_view summary, const std::vector<glsl::bound>& items, const std::string& text) {
    const std::string note = glsl::detail::bounds_note(*l.words, items);
    std::string head = comment("umbrage " + version + ", " + name + ": " + std::string(summary) + ". Exactness: tier " +
                               "ABC"[static_cast<int>(glsl::exactness(items))] + '.');
    head += note;
    head += "// SPDX-License-Identifier: MIT\n";
    head += "// " + copyright + ". License text: LICENSE in the umbrage repository.\n";
    for (const glsl::bound& item : items) head += map_of(l, item) + targets_of(item.what);
    std::string rest = text.substr(text.find('\n') + 1);
    if (rest.starts_with(note)) rest.erase(0, note.size());
    return head + options_of(items) + rest;
}

/// A snippet, as a plain map has it, behind all it needs.
inline void collect(const snippet& asked, std::vector<const snippet*>& all) {
    const snippet& s = glsl::detail::chosen(asked, {});
    for (const snippet* need : s.needs) collect(*need, all);
    if (std::find(all.begin(), all.end(), &s) == all.end()) all.push_back(&s);
}

/// File of one function, which names the others. For languages in which two pasted texts would clash.
inline std::string one_function(const shader_language& l, const snippet& s, std::string_view joined) {
    std::vector<const snippet*> all;
    collect(s, all);
    std::string others;
    for (const snippet* need : all)
        if (need != &s) others += (others.empty() ? "" : ", ") + std::string(need->name) + std::string(l.extension);
    if (!others.empty()) others = comment("Paste along: " + others + "; or paste " + std::string(joined) + " alone.");
    return '\n' + others +
           glsl::detail::laid_out(
               glsl::detail::for_map(l.words->translate(s), s, s, l.words->texture(glsl::texture::texture_2d)));
}

/// Summary of a snippet. A map's hook has it in its comment.
inline std::string summary_of(const snippet& s) {
    if (!s.summary.starts_with(s.name)) return std::string(s.summary);
    const std::string text = s.source.str(), start = "// umbrage_" + std::string(s.name) + ": ";
    const auto begin = text.find(start) + start.size();
    return text.substr(begin, text.find_first_of(";\n", begin) - begin);
}

struct pasted {
    std::string name;
    std::string_view summary;
    std::vector<glsl::bound> items;
};

/// Files for comparison samplers. A search for blockers reads depths of the same texture.
inline std::vector<pasted> for_comparison_samplers() {
    std::vector<pasted> all;
    const glsl::binding shadow{.texture = glsl::texture::shadow};
    for (const snippet* s : compared_by_samplers)
        all.push_back({std::string(s->name) + "_shadow", s->summary, {bind(*s, "shadow", shadow)}});
    all.push_back({"pcss_hardware16_shadow",
                   "percentage-closer soft shadows (PCSS) at 16 points, one texture bound to two samplers",
                   {glsl::disc_rotation, glsl::pcss_radius,
                    bind(glsl::blockers_hardware<16>, "depths", {.texture = glsl::texture::depth}),
                    bind(glsl::disc_hardware<16>, "shadow", shadow)}});
    return all;
}

inline void write_shaders(const fs::path& folder, const std::string& copyright) {
    for (const shader_language& l : languages) {
        const std::string joined = std::string(l.name) + (l.words->preprocessor ? "" : "_joined");
        std::vector<pasted> files = for_comparison_samplers();
        for (const snippet* s : glsl::registry()) files.push_back({std::string(s->name), s->summary, {*s}});
        for (const pasted& p : files)
            write(folder / joined / (p.name + std::string(l.extension)),
                  with_head(l, copyright, p.name, p.summary, p.items, l.text(p.items)));
        if (l.words->preprocessor) continue;
        std::vector<const snippet*> parts;
        for (const snippet* s : glsl::registry()) collect(*s, parts);
        for (const snippet* part : parts) {
            const std::string name(part->name), file = name + std::string(l.extension);
            write(folder / l.name / file, with_head(l, copyright, name, summary_of(*part), {*part},
                                                    one_function(l, *part, joined + '/' + file)));
        }
    }
}

}  // namespace package
