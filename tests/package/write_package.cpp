// SPDX-License-Identifier: MIT
//
// Writes what needs no build:  write_package TEMPLATES FOLDER
//
// FOLDER/shaders                           files to paste: see paste.hpp
// FOLDER/umbrage.mjs, wgsl.mjs, ...        the npm package's entries, one a language, and their types
// FOLDER/module                            what they are made of: TEMPLATES/module, and data of module.hpp
// FOLDER/LICENSE                           a copy, which the package carries
// FOLDER/**.cjs, FOLDER/*.d.cts            the same for Node's require
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "commonjs.hpp"
#include "module.hpp"
#include "module_debug.hpp"
#include "module_encodings.hpp"
#include "module_names.hpp"
#include "module_shadows.hpp"
#include "paste.hpp"

namespace package {
namespace {

/// A file with each @key@ replaced.
std::string filled(const fs::path& path, std::initializer_list<std::pair<std::string_view, std::string>> values = {}) {
    std::ifstream file(path);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.empty()) throw std::runtime_error("cannot read " + path.string());
    const auto replace = [&](std::string_view key, std::string_view value) {
        for (auto at = text.find(key); at != text.npos; at = text.find(key, at + value.size()))
            text.replace(at, key.size(), value);
    };
    replace("@version@", version);
    for (const auto& [key, value] : values) replace(key, value);
    return text;
}

void write_module(const fs::path& path, const std::string& text) {
    write(fs::path(path) += ".mjs", text);
    write(fs::path(path) += ".cjs", as_commonjs(text));
}

void write_types(const fs::path& path, std::string text) {
    write(fs::path(path) += ".d.mts", text);
    for (auto at = text.find(".mjs'"); at != text.npos; at = text.find(".mjs'", at)) text.replace(at, 5, ".cjs'");
    write(fs::path(path) += ".d.cts", text);
}

/// Declarations of what the data export.
std::string names() {
    std::string out;
    umbrage::for_each_encoding([&](const auto& e) {
        out += "/** " + std::string(e.summary) + " */\nexport const " + std::string(e.name) + ": Encoding;\n";
    });
    for (const kind_of_light& kind : kinds)
        out += "/** " + std::string(kind.summary) + " */\nexport const " + std::string(kind.name) + ": Light;\n";
    for (const snippet* s : glsl::registry())
        out += "/** " + std::string(s->summary) + " */\nexport const " + std::string(s->name) + ": Snippet;\n";
    return out;
}

std::string names_of_encodings() {
    std::string out;
    umbrage::for_each_encoding(
        [&](const auto& e) { out += (out.empty() ? "'" : " | '") + std::string(e.name) + '\''; });
    return out;
}

void write_npm(const fs::path& templates, const fs::path& folder) {
    for (const char* const part : {"check", "compose", "bind", "fill", "declare", "functions", "shadow", "versions"})
        write_module(folder / "module" / part, filled(templates / (std::string(part) + ".mjs")));
    write_types(folder / "module/types", filled(templates / "types.d.mts", {{"@encodings@", names_of_encodings()}}));
    write_module(folder / "module/names", names_module());
    write_module(folder / "module/clip_spaces", clip_spaces_module());
    write_module(folder / "values", filled(templates / "values.mjs"));
    write_types(folder / "values", filled(templates / "values.d.mts", {{"@clip_spaces@", types_of_clip_spaces()}}));
    for (const shader_language& l : languages) {
        const fs::path data = folder / "module" / l.name;
        write_module(data / "language", language_module(l));
        write_module(data / "snippets", snippets_module(l));
        write_module(data / "hooks", hooks_module(l));
        write_module(data / "looks", looks_module(l));
        write_module(data / "kinds", kinds_module(l));
        write_module(data / "debug", debug_module(l));
        write_module(data / "encodings", encodings_module(l));
        const bool is_glsl = l.name == "glsl", is_wgsl = l.name == "wgsl";
        const std::string name(l.name), entry = is_glsl ? "umbrage" : name;
        const std::string texts = filled(templates / (is_glsl ? "versions.d.mts" : "text.d.mts"));
        write_module(folder / entry,
                     filled(templates / (is_glsl ? "glsl.mjs" : "other.mjs"),
                            {{"@language@", name},
                             {"@Language@", std::string(l.title)},
                             {"@functions@", is_wgsl ? "export { functions } from './module/functions.mjs';\n" : ""}}));
        write_types(folder / entry,
                    filled(templates / "entry.d.mts",
                           {{"@language@", name},
                            {"@names@", names()},
                            {"@texts@", texts + (is_wgsl ? filled(templates / "functions.d.mts") : "")}}));
    }
}

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const std::filesystem::path templates = argv[1], folder = argv[2];
        std::filesystem::remove_all(folder / "shaders");  // those of snippets that are no more, too
        std::filesystem::remove_all(folder / "module");
        package::write_shaders(folder / "shaders", package::copyright(templates / "../../LICENSE"));
        package::write_npm(templates / "module", folder);
        package::write(folder / "LICENSE", package::filled(templates / "../../LICENSE"));
    } catch (const std::exception& error) {
        std::cerr << "write_package: " << error.what() << '\n';
        return 1;
    }
}
