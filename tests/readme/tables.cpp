// SPDX-License-Identifier: MIT
#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <type_traits>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/registry.hpp>

#include "headers.hpp"

namespace readme {
namespace {

namespace glsl = umbrage::glsl;

std::string code(std::string_view name) { return "`" + std::string(name) + "`"; }

std::string span(std::string_view first, std::string_view last) {
    return first == last ? code(first) : code(first) + " to " + code(last);
}

std::string decimal(double v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", v);
    return text;
}

std::string power_of_two(double v) {
    int exponent = 0;
    return v > 0.0 && std::frexp(v, &exponent) == 0.5 ? "2^" + std::to_string(exponent - 1) : decimal(v);
}

/// Where the header is that defines a family's snippets.
std::string home_of(const std::filesystem::path& include, const family& f) {
    const std::string name(f.names.front()), quoted = '"' + name + '"';
    const std::string stem = std::regex_replace(name, std::regex("[0-9]+"), "");
    for (const auto& [place, text] : headers(include))
        for (const std::string& sign : {".name = " + quoted, "? " + quoted, "snippet " + stem + '{'})
            if (text.find(sign) != text.npos) return folder_of(place);
    throw std::runtime_error("no header defines the snippet " + name);
}

/// The page that lists a folder's names.
std::string page_of(const std::vector<page>& pages, const std::string& folder) {
    const std::regex lists("<!-- begin: (?:names|primitives)[^>]* " + folder + "(?: |/\\w+\\.hpp)");
    for (const page& p : pages)
        if (std::regex_search(p.text, lists)) return p.path;
    throw std::runtime_error("no page lists the names of " + folder);
}

}  // namespace

std::string family::label() const { return span(names.front(), names.back()); }

std::vector<family> families() {
    std::vector<family> all;
    for (const glsl::snippet* s : glsl::registry()) {
        if (all.empty() || all.back().first->summary != s->summary) all.push_back({{}, s});
        all.back().names.push_back(s->name);
    }
    return all;
}

std::string primitives(const std::filesystem::path& include, const std::vector<std::string>& folders) {
    std::string table = "| primitive | what it does | tier |\n|---|---|---|\n";
    for (const family& f : families())
        if (std::find(folders.begin(), folders.end(), home_of(include, f)) != folders.end())
            table += "| " + f.label() + " | " + std::string(f.first->summary) +
                     (f.first->lowest == glsl::version::v100 ? "" : "; from GLSL 330 or 300 es on") + " | " +
                     glsl::promise(*f.first) + " |\n";
    return table;
}

std::string encodings() {
    struct row {
        std::string_view first, last, summary;
        std::string texel, below, above;
    };
    std::vector<row> rows;
    const auto append = [](std::string& range, const std::string& last) {
        const auto first = range.substr(0, range.find(" to "));
        range = first == last ? first : first + " to " + last;
    };
    umbrage::for_each_encoding([&](const auto& e) {
        using texel = typename std::decay_t<decltype(e)>::texel;
        const auto error = e.error();
        if (rows.empty() || rows.back().summary != e.summary)
            rows.push_back({e.name, e.name, e.summary,
                            std::is_same_v<texel, float> ? "float" : std::to_string(sizeof(texel)) + " x 8 bits",
                            power_of_two(error.below), power_of_two(error.above)});
        rows.back().last = e.name;
        append(rows.back().below, power_of_two(error.below));
        append(rows.back().above, power_of_two(error.above));
    });
    std::string table = "| encoding | what it is | texel | too near by | too far by |\n|---|---|---|--:|--:|\n";
    for (const row& r : rows)
        table += "| " + span(r.first, r.last) + " | " + std::string(r.summary) + " | " + r.texel + " | " + r.below +
                 " | " + r.above + " |\n";
    return table;
}

std::string filters() {
    std::string table = "| filter | what it does | reach | tier |\n|---|---|--:|---|\n";
    umbrage::for_each_filter([&](const auto& f) {
        const glsl::snippet& s = *f.snippet;
        table += "| " + code(f.name) + " | " + std::string(s.summary) + " | " + decimal(f.reach()) + " | " +
                 glsl::promise(s) + " |\n";
    });
    return table;
}

std::string names(const std::filesystem::path& page, const std::filesystem::path& include,
                  const std::vector<std::string>& of) {
    std::string table = "| names | what for |\n|---|---|\n";
    const auto rows = table.size();
    for (const auto& [place, header] : headers(include)) {
        if (std::none_of(of.begin(), of.end(), [&](auto& each) { return each == place || each == folder_of(place); }))
            continue;
        std::string names;
        for (const std::string& name : names_in(header))
            if (std::none_of(glsl::registry().begin(), glsl::registry().end(),
                             [&](auto* s) { return s->name == name; }))
                names += (names.empty() ? "" : ", ") + code(name);
        const auto link = std::filesystem::relative(include / place, page.parent_path()).generic_string();
        if (!names.empty()) table += "| " + names + " | [" + opening_sentence(header) + "](" + link + ") |\n";
    }
    if (table.size() == rows) throw std::runtime_error("no names in " + of.at(0));
    return table;
}

std::string index(const std::vector<page>& pages, const std::filesystem::path& include,
                  const std::vector<std::string>& folders) {
    std::string list;
    for (const std::string& folder : folders)
        for (const auto& [place, header] : headers(include)) {
            if (folder_of(place) != folder) continue;
            for (const auto& [elsewhere, here] : also_called_in(place, header)) {
                std::string names;
                for (const std::string& name : here)
                    names += (names.empty() ? "[" : ", [") + code(name) + "](" + page_of(pages, folder) + ")";
                list += "- " + elsewhere + ": " + names + "\n";
            }
        }
    return list;
}

std::string paths(const std::filesystem::path& list) {
    static const std::map<std::string, std::string> called{
        {"webgl1", "WebGL 1"}, {"webgl2", "WebGL 2"},   {"webgpu", "WebGPU"},      {"opengl", "OpenGL 3.3"},
        {"vulkan", "Vulkan"},  {"glsl110", "GLSL 110"}, {"hlsl", "Vulkan by HLSL"}};
    std::ifstream in(list);
    std::string table = "| light, filter, encoding, map | with | drawn in |\n|---|---|---|\n";
    const auto head = table.size();
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string word;
        for (int part = 0; part < 4 && words >> word; ++part) table += (part == 0 ? "| " : ", ") + code(word);
        std::string direction, further;
        words >> direction >> further;
        table += " | " + direction + (further == "-" ? "" : ", " + further);
        std::string apis;
        while (words >> word) {
            const auto name = called.find(word.substr(0, word.find('*')));
            if (name == called.end()) throw std::runtime_error(list.string() + ": no API is called " + word);
            apis += (apis.empty() ? "" : ", ") + name->second;
        }
        table += " | " + apis + " |\n";
    }
    if (table.size() == head) throw std::runtime_error("no paths in " + list.string());
    return table;
}

}  // namespace readme
