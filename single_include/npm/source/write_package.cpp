// SPDX-License-Identifier: MIT
//
// Writes what needs no build:  write_package SOURCE FOLDER
//
// FOLDER/shaders                           files to paste: see paste.hpp
// FOLDER/umbrage.mjs, wgsl.mjs, ...        the npm package's entries, one a language, and their types
// FOLDER/module                            the data of module.hpp, and types. npm/compose makes texts of them, by hand
// FOLDER/LICENSE                           a copy, which the package carries
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

#include "module.hpp"
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

void write_module(const fs::path& path, const std::string& text) { write(fs::path(path) += ".mjs", text); }

void write_types(const fs::path& path, const std::string& text) { write(fs::path(path) += ".d.mts", text); }

/// Lines of a template that are of a language: those between `//@ glsl hlsl` and the next `//@` are of these two.
std::string lines_of(std::string_view language, const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    bool taken = true;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("//@")) taken = line == "//@" || line.find(language) != line.npos;
        else if (taken) out += line + '\n';
    }
    return out;
}

/// Declarations of what the data export.
std::string names() {
    std::string out;
    umbrage::for_each_encoding([&](const auto& e) {
        out += "/** " + std::string(e.summary) + " */ export const " + std::string(e.name) + ": Encoding;\n";
    });
    for (const kind_of_light& kind : kinds)
        out += "/** " + std::string(kind.summary) + " */ export const " + std::string(kind.name) + ": Light;\n";
    for (const snippet* s : glsl::registry())
        out += "/** " + std::string(s->summary) + " */ export const " + std::string(s->name) + ": Snippet;\n";
    return out;
}

/// A union of names, as TypeScript has it.
class union_of_names {
public:
    void add(std::string_view name) { text_ += (text_.empty() ? "'" : " | '") + std::string(name) + '\''; }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

std::string names_of_lights() {
    std::string all;
    for (const kind_of_light& kind : kinds) all += (all.empty() ? "" : ", ") + std::string(kind.name);
    return all;
}

std::string names_of_encodings() {
    union_of_names all;
    umbrage::for_each_encoding([&](const auto& e) { all.add(e.name); });
    return all.text();
}
std::string names_of_snippets() {
    union_of_names all;
    for (const snippet* s : glsl::registry()) all.add(s->name);
    return all.text();
}

void write_npm(const fs::path& templates, const fs::path& folder) {
    write_module(folder / "module/languages",
                 "export const version = " + literal(version) + ";\n\n" + languages_module());
    write_types(folder / "module/types", filled(templates / "types.d.mts", {{"@encodings@", names_of_encodings()},
                                                                            {"@snippets@", names_of_snippets()}}));
    write_module(folder / "module/names", names_module());
    write_module(folder / "values", filled(templates / "values.mjs", {{"@clip_spaces@", clip_spaces_module()}}));
    write_types(folder / "values", filled(templates / "values.d.mts", {{"@clip_spaces@", types_of_clip_spaces()}}));
    for (const shader_language& l : languages) {
        const fs::path data = folder / "module" / l.name;
        write_module(data / "snippets", snippets_module(l));
        write_module(data / "encodings", encodings_module(l));
        write_module(data / "shadows", imports_of(l) + '\n' + hooks_in_module(l) + calls_in_module() +
                                           kinds_in_module() + debug_in_module(l));
        const std::string name(l.name), entry = l.name == "glsl" ? "umbrage" : name;
        const auto of_language = [&](const char* file) {
            return lines_of(l.name, filled(templates / file, {{"@language@", name},
                                                              {"@Language@", std::string(l.title)},
                                                              {"@lights@", names_of_lights()},
                                                              {"@names@", names()}}));
        };
        write_module(folder / entry, of_language("entry.mjs"));
        write_types(folder / entry, of_language("entry.d.mts"));
    }
}

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const std::filesystem::path source = argv[1], license = source / "../../../LICENSE", folder = argv[2];
        std::filesystem::remove_all(folder / "shaders");  // those of snippets that are no more, too
        std::filesystem::remove_all(folder / "module");
        package::write_shaders(folder / "shaders", package::copyright(license));
        package::write_npm(source / "templates", folder);
        package::write(folder / "LICENSE", package::filled(license));
    } catch (const std::exception& error) {
        std::cerr << "write_package: " << error.what() << '\n';
        return 1;
    }
}
