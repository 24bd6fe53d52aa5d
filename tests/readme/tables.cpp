// SPDX-License-Identifier: MIT
#include "tables.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <stdexcept>
#include <type_traits>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/shader/registry.hpp>

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

/// The first sentence of the comment that a header opens with.
std::string opening_sentence(const std::string& header) {
    std::string words;
    auto at = header.find("//\n") + 3;
    for (; header.compare(at, 3, "// ") == 0; at = header.find('\n', at) + 1) {
        words += (words.empty() ? "" : " ") + header.substr(at + 3, header.find('\n', at) - at - 3);
        for (std::size_t i = 1; i < words.size(); ++i)
            if (words[i] == '.' && (i + 1 == words.size() || words[i + 1] == ' ') &&
                (std::isalnum(static_cast<unsigned char>(words[i - 1])) || words[i - 1] == ')' || words[i - 1] == ']'))
                return words.substr(0, i);
    }
    throw std::runtime_error("no header comment with a sentence: " + header.substr(0, 200));
}

/// Functions at the beginning of a line outside namespace detail, in order, each once.
std::vector<std::string> functions_in(const std::string& header) {
    const std::regex inside("namespace detail \\{[^]*?\\}  // namespace detail");
    const std::string users = std::regex_replace(header, inside, "");
    const std::regex function(
        "(?:^|\n)(?:requires\\([^)]*\\)\\s*)?(?:\\[\\[nodiscard\\]\\] )?(?:inline |constexpr )*[a-zA-Z_:][\\w:<>, +]* "
        "(\\w+)\\(");
    std::vector<std::string> names;
    for (std::sregex_iterator i(users.begin(), users.end(), function), end; i != end; ++i)
        if (std::find(names.begin(), names.end(), (*i)[1]) == names.end()) names.push_back((*i)[1]);
    return names;
}

/// Headers' texts by their places in `include`.
const std::map<std::string, std::string>& headers(const std::filesystem::path& include) {
    static const auto all = [&] {
        std::map<std::string, std::string> texts;
        for (const auto& file : std::filesystem::recursive_directory_iterator(include)) {
            if (file.path().extension() != ".hpp") continue;
            std::ifstream in(file.path());
            texts[std::filesystem::relative(file.path(), include).generic_string()] = {
                std::istreambuf_iterator<char>(in), {}};
        }
        return texts;
    }();
    return all;
}

std::string folder_of(const std::string& place) { return place.substr(0, place.find_last_of('/')); }

/// Where the header is that defines a family's snippets.
std::string folder_of(const std::filesystem::path& include, const family& f) {
    const std::string name(f.names.front()), quoted = '"' + name + '"';
    const std::string stem = std::regex_replace(name, std::regex("[0-9]+"), "");
    for (const auto& [place, text] : headers(include))
        for (const std::string& sign : {".name = " + quoted, "? " + quoted, "snippet " + stem + '{'})
            if (text.find(sign) != text.npos) return folder_of(place);
    throw std::runtime_error("no header defines the snippet " + name);
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
    std::string table = "| primitive | what it does | tier | lowest GLSL |\n|---|---|---|---|\n";
    for (const family& f : families())
        if (std::find(folders.begin(), folders.end(), folder_of(include, f)) != folders.end())
            table += "| " + f.label() + " | " + std::string(f.first->summary) + " | " + glsl::promise(*f.first) +
                     (f.first->lowest == glsl::version::v100 ? " | 100 |\n" : " | 330, 300 es |\n");
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
    std::string table = "| encoding | what it is | texel | decoded too near by | too far by |\n|---|---|---|--:|--:|\n";
    for (const row& r : rows)
        table += "| " + span(r.first, r.last) + " | " + std::string(r.summary) + " | " + r.texel + " | " + r.below +
                 " | " + r.above + " |\n";
    return table;
}

std::string filters() {
    std::string table = "| filter | in GLSL | what it does | reach | tier |\n|---|---|---|--:|---|\n";
    umbrage::for_each_filter([&](const auto& f) {
        const glsl::snippet& s = *f.snippet;
        table += "| " + code(f.name) + " | " + code("umbrage_" + std::string(s.name)) + " | " + std::string(s.summary) +
                 " | " + decimal(f.reach()) + " | " + glsl::promise(s) + " |\n";
    });
    return table;
}

std::string functions(const std::filesystem::path& include, const std::vector<std::string>& folders) {
    std::map<std::string, std::string> rows;  // in the order of the headers' names
    for (const auto& [place, header] : headers(include)) {
        if (std::find(folders.begin(), folders.end(), folder_of(place)) == folders.end()) continue;
        std::string names;
        for (const std::string& name : functions_in(header))
            if (!name.starts_with("umbrage_") && std::none_of(glsl::registry().begin(), glsl::registry().end(),
                                                              [&](auto* s) { return s->name == name; }))
                names += (names.empty() ? "" : ", ") + code(name);
        if (!names.empty())
            rows[place] = "| " + names + " | " + opening_sentence(header) + " | " + code(place) + " |\n";
    }
    if (rows.empty()) throw std::runtime_error("no functions in " + folders.at(0));
    std::string table = "| functions | what for | header |\n|---|---|---|\n";
    for (const auto& [place, row] : rows) table += row;
    return table;
}

}  // namespace readme
