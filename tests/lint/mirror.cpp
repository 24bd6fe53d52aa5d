// SPDX-License-Identifier: MIT
//
// Tests lie where their headers do: unit/<path>.cpp, or files in a folder unit/<path>/, and parity/entries/<path>.cpp
// for a header that defines snippets. Engines that users never call may do without: image functions test them.
// Lists hold what headers define: encodings, filters, snippets. A failure says what to add, and where.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using paths = std::vector<std::string>;

const fs::path root = UMBRAGE_SOURCE_DIR;

std::string read(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Files below a folder, without the folder and the extension.
paths below(const fs::path& folder, const std::string& extension) {
    paths found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == extension)
            found.push_back(fs::relative(entry.path(), folder).replace_extension().generic_string());
    std::sort(found.begin(), found.end());
    return found;
}

const paths headers = below(root / "include/umbrage", ".hpp");
const paths unit_tests = below(root / "tests/unit", ".cpp");
const paths parity_entries = below(root / "tests/parity/entries", ".cpp");

std::string text_of(const std::string& header) { return read(root / "include/umbrage" / (header + ".hpp")); }

/// Ours alone: what functions over images run on.
bool is_engine(const std::string& header) {
    return header.starts_with("simd/") || header.starts_with("images/blocks/") || header.starts_with("draw/raster/") ||
           header == "images/codec";
}

/// Something to call, besides comments and directives.
bool has_functions(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("#") && line.substr(0, line.find("//")).find('(') != line.npos) return true;
    return false;
}

/// The names that follow `inline constexpr snippet`, of those whose members before the text have some words.
paths snippets_in(const std::string& text, const std::string& words = "") {
    paths names;
    const std::string key = "inline constexpr snippet ";
    for (auto at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
        const auto start = at + key.size();
        if (text.substr(start, text.find(".source", start) - start).find(words) != text.npos)
            names.push_back(text.substr(start, text.find_first_of("{;= ", start) - start));
    }
    return names;
}

/// Structs with a member: encodings, filters and prefilters as values have a name.
paths values_in(const std::string& text, const std::string& member = "string_view name = ") {
    paths names;
    const std::string key = "\nstruct ";
    for (auto at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
        const std::string body = text.substr(at + key.size(), text.find("\n};", at) - at - key.size());
        if (body.find(member) != body.npos) names.push_back(body.substr(0, body.find_first_of(" {")));
    }
    return names;
}

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("(?:^|\\W)" + word + "\\b"));
}

/// path:line of the first `words` of a file, or of its first line.
std::string place_of(const std::string& path, const std::string& words) {
    const std::string text = read(root / path);
    const auto at = std::min(text.find(words), text.size());
    const auto line = at == text.size() ? 1 : 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
    return path + ':' + std::to_string(line);
}

/// A header's list of its snippets, up to the semicolon; empty where it has none.
std::string list_in(const std::string& text, const std::string& list) {
    const auto at = text.find(list);
    return at == text.npos ? "" : text.substr(at, text.find(';', at) - at);
}

bool is_test_of(const std::string& test, const std::string& header) {
    return test == header || test.starts_with(header + "/");
}

bool tested(const std::string& header, const paths& tests) {
    return std::any_of(tests.begin(), tests.end(), [&](const std::string& t) { return is_test_of(t, header); });
}

bool has_header(const std::string& test) {
    return std::any_of(headers.begin(), headers.end(), [&](const std::string& h) { return is_test_of(test, h); });
}

}  // namespace

TEST_CASE("the mirror sees what it should") {
    CHECK(tested("a/b", {"a/b"}));
    CHECK(tested("a/b", {"c", "a/b/d"}));
    CHECK_FALSE(tested("a/b", {"a", "a/bc", "b"}));
    CHECK(has_functions("// a\n#define B\n    int c();\n"));
    CHECK_FALSE(has_functions("// a()\n\n#define B()\n#include <c>\nstruct d {\n    int e;  // f()\n};\n"));
    CHECK(snippets_in("inline constexpr snippet a{.name\n  inline constexpr snippet b = c;") == paths{"a", "b"});
    CHECK(snippets_in("inline constexpr snippet a{tier::b, .source}\ninline constexpr snippet c{tier::a, .source}",
                      "tier::a") == paths{"c"});
    CHECK(values_in("\nstruct a {\n    std::string_view name = \"b\";\n};\n\nstruct c {\n    d e{};\n};\n") ==
          paths{"a"});
    CHECK(place_of("include/umbrage/version.hpp", "// SPDX").ends_with(".hpp:1"));
    CHECK(list_in("auto a_snippets = list<&a,\n &b>;\nc;", "a_snippets") == "a_snippets = list<&a,\n &b>");
    CHECK(has_header("core/scalar"));
    CHECK_FALSE(has_header("no such header"));
}

TEST_CASE("every header for users has a unit test, and every unit test a header") {
    for (const std::string& header : headers) {
        if (!is_engine(header) && has_functions(text_of(header)))
            CHECK_MESSAGE(tested(header, unit_tests),
                          "add tests/unit/" << header << ".cpp, tests of include/umbrage/" << header << ".hpp");
    }
    for (const std::string& test : unit_tests) {
        CAPTURE(test);
        CHECK(
            (has_header(test) || fs::is_directory(root / "include/umbrage" / test)));  // of a folder's headers together
    }
}

TEST_CASE("every header with snippets has parity entries of each of them, and every file of entries a header") {
    for (const std::string& header : headers) {
        const paths snippets = snippets_in(text_of(header));
        if (snippets.empty() || header.starts_with("shader/hooks/")) continue;  // parity looks itself for each of those
        const std::string path = "tests/parity/entries/" + header + ".cpp", entries = read(root / path);
        const bool by_values = entries.find("::values)") != entries.npos;  // of a filter's, each with its snippet
        for (const std::string& name : snippets)
            CHECK_MESSAGE((by_values || has_word(entries, "glsl::" + name)),
                          "add an entry of glsl::" << name << " to " << place_of(path, "void add_"));
    }
    for (const std::string& entries : parity_entries) {
        CAPTURE(entries);
        CHECK(has_header(entries));
    }
}

TEST_CASE("every encoding, filter and prefilter is in the list of its kind") {
    for (const std::string& header : headers) {
        const char* list = header.starts_with("depth/") ? "include/umbrage/depth/encodings.hpp"
                           : header.starts_with("filter/prefiltered/")
                               ? "include/umbrage/filter/prefiltered/prefilters.hpp"
                           : header.starts_with("filter/") ? "include/umbrage/filter/filters.hpp"
                                                           : "";
        if (!*list) continue;
        std::string listed;
        const std::string text = read(root / list);
        for (auto at = text.find("list_of<"); at != text.npos; at = text.find("list_of<", at + 1))
            listed += list_in(text.substr(at), "list_of<");
        for (const std::string& name : values_in(text_of(header)))
            CHECK_MESSAGE(has_word(listed, name), "add " << name << " to the list in " << place_of(list, "list_of<")
                                                         << ", and #include <umbrage/" << header << ".hpp> above");
    }
}

TEST_CASE("every snippet of tier A, but those of the lists of filters and encodings, has a run in proof/hostile") {
    const std::string folder = "tests/proof/hostile/", path = folder + "tier_a.cpp";
    std::string runs;
    for (const char* file : {"tier_a.cpp", "light.hpp", "soft_shadows.hpp", "debug.hpp"})
        runs += read(root / folder / file);
    for (const std::string& header : headers) {
        const std::string text = text_of(header);
        if (header.starts_with("shader/hooks/") || text.find("namespace filters {") != text.npos) continue;
        const bool has_edge = !values_in(text, " edge = ").empty();  // an encoding: the list of them runs both snippets
        for (const std::string& name : snippets_in(text, "tier::a"))
            if (!has_edge || !has_word(text, "(writer|reader) = &glsl::" + name))
                CHECK_MESSAGE(has_word(runs, name),
                              "add a run of " << name << " to " << place_of(path, "void suite::all()"));
    }
}

TEST_CASE("every snippet is in its header's list or of a value, and every header's list in the registry") {
    const std::string registry = "include/umbrage/registry.hpp", listed = read(root / registry);
    for (const std::string& header : headers) {
        const std::string text = text_of(header), path = "include/umbrage/" + header + ".hpp";
        const std::string list = fs::path(header).filename().string() + "_snippets", members = list_in(text, list);
        if (header.starts_with("shader/hooks/")) continue;  // maps choose among those
        for (const std::string& name : snippets_in(text)) {
            if (!members.empty())
                CHECK_MESSAGE(has_word(members, '&' + name),
                              "add &" << name << " to " << list << ", " << place_of(path, list));
            else
                CHECK_MESSAGE(has_word(text, "&(glsl::)?" + name),
                              "no encoding or filter names glsl::"
                                  << name << ": end namespace glsl, " << place_of(path, "}  // namespace glsl")
                                  << ", with\ninline constexpr const snippet* " << list << "[]{&" << name << "};");
        }
        if (!members.empty())
            CHECK_MESSAGE(has_word(listed, list), "add " << list << " below " << place_of(registry, "collection<Use>()")
                                                         << ", and #include <umbrage/" << header << ".hpp> above");
    }
}
