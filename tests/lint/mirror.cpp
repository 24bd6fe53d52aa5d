// SPDX-License-Identifier: MIT
//
// Tests lie where their headers do: unit/<path>.cpp, or files in a folder unit/<path>/, and parity/entries/<path>.cpp
// for a header that defines snippets. Engines that users never call may do without: image functions test them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
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
    return header.starts_with("simd/") || header.starts_with("images/blocks/") || header.starts_with("images/raster/");
}

/// Something to call, besides comments and directives.
bool has_functions(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("#") && line.substr(0, line.find("//")).find('(') != line.npos) return true;
    return false;
}

/// The names that follow `inline constexpr snippet`.
paths snippets_in(const std::string& text) {
    paths names;
    const std::string key = "inline constexpr snippet ";
    for (auto at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
        const auto start = at + key.size();
        names.push_back(text.substr(start, text.find_first_of("{;= ", start) - start));
    }
    return names;
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
    CHECK(has_header("core/scalar"));
    CHECK_FALSE(has_header("no such header"));
}

TEST_CASE("every header for users has a unit test, and every unit test a header") {
    for (const std::string& header : headers) {
        if (!is_engine(header) && has_functions(text_of(header)))
            CHECK_MESSAGE(tested(header, unit_tests), "there is no tests/unit/" << header << ".cpp");
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
        if (snippets.empty() || header.ends_with("hooks")) continue;  // parity looks itself for each of those
        CAPTURE(header);
        CHECK_MESSAGE(tested(header, parity_entries), "there is no tests/parity/entries/" << header << ".cpp");
        const std::string entries = read(root / "tests/parity/entries" / (header + ".cpp"));
        for (const std::string& name : snippets) {
            CAPTURE(name);
            const bool by_values = entries.find("::values)") != entries.npos;  // of a filter's, each with its snippet
            CHECK((by_values || entries.find("glsl::" + name) != entries.npos));
        }
    }
    for (const std::string& entries : parity_entries) {
        CAPTURE(entries);
        CHECK(has_header(entries));
    }
}
