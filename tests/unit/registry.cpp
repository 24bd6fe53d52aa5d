// SPDX-License-Identifier: MIT
//
// The registry against the headers' own text: a snippet that a header defines and nobody lists fails here.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>

using namespace umbrage::glsl;

namespace {

struct found {
    std::string header;
    std::string cpp;   ///< the header's text before `namespace glsl`
    std::string name;  ///< as C++ has it, without a family's number
    bool family;
};

/// Every `inline constexpr snippet NAME{` below include/umbrage.
std::vector<found> snippets_in_headers() {
    std::vector<found> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(UMBRAGE_SOURCE_DIR "/include/umbrage")) {
        const bool what_maps_choose = entry.path().parent_path().filename() == "hooks";
        if (entry.path().extension() != ".hpp" || what_maps_choose) continue;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const std::string key = "inline constexpr snippet ";
        for (auto at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
            const auto start = at + key.size(), end = text.find_first_of("{;= ", start);
            const auto line_before = text.rfind('\n', at - 2) + 1;
            all.push_back({entry.path().filename().string(), text.substr(0, text.find("namespace glsl {")),
                           text.substr(start, end - start), text.compare(line_before, 8, "template") == 0});
        }
    }
    return all;
}

/// A family's name: encode_rg of encode_rg11.
std::string without_digits(std::string_view name) {
    std::string out;
    for (char c : name)
        if (!std::isdigit(static_cast<unsigned char>(c))) out += c;
    return out;
}

}  // namespace

TEST_CASE("registry: lists every snippet of every header once, and nothing else") {
    std::map<std::string, int> listed;  // by name, families without their digits
    std::set<std::string_view> names;
    const auto headers = snippets_in_headers();
    std::set<std::string> families, singles;
    for (const found& f : headers) (f.family ? families : singles).insert(f.name);
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(names.insert(s->name).second);
        const bool member = !singles.contains(std::string(s->name)) && families.contains(without_digits(s->name));
        ++listed[member ? without_digits(s->name) : std::string(s->name)];
    }
    CHECK(headers.size() > 30);
    CHECK(families.count("encode_rg") == 1);
    for (const found& f : headers) {
        CHECK_MESSAGE((f.family ? listed[f.name] >= 1 : listed[f.name] == 1),
                      f.name << " of " << f.header << " is listed " << listed[f.name]
                             << " times; `make lint` says where it is missing");
        listed.erase(f.name);
    }
    for (const auto& unclaimed : listed) {
        CAPTURE(unclaimed.first);
        CHECK(unclaimed.second == 0);  // listed, but in no header
    }
}

TEST_CASE("registry: each snippet has a C++ twin of its name in its header") {
    for (const found& f : snippets_in_headers()) {
        CAPTURE(f.header);
        CAPTURE(f.name);
        std::string twin = f.name;  // a size at the end is an argument in C++
        if (f.cpp.find(" " + twin + "(") == f.cpp.npos) twin.erase(twin.find_last_not_of("0123456789") + 1);
        CHECK(f.cpp.find(" " + twin + "(") != f.cpp.npos);
    }
}

TEST_CASE("registry: the C++ twin's comment promises what the snippet does") {
    std::set<std::string_view> told;
    const auto headers = snippets_in_headers();
    for (const snippet* s : registry()) {
        if (s->exactness == tier::a) continue;
        CAPTURE(s->name);
        CAPTURE(promise(*s));
        std::string pattern = promise(*s);  // of a family a list: "B, n = 7, 12, 17 of 3, 5, 7 taps"
        if (s->operations > 0) pattern.insert(pattern.rfind(' ') + 1, "(?:\\d+(?:, | or ))*");
        for (const found& f : headers) {
            if (f.name != s->name && !(f.family && f.name == without_digits(s->name))) continue;
            std::string twin = f.name;
            if (f.cpp.find(' ' + twin + '(') == f.cpp.npos) twin.erase(twin.find_last_not_of("0123456789") + 1);
            // The comment, a template's head, which may fill lines, and the function's.
            const std::regex comment("@exactness +" + pattern + "\\b(?:.*\n///)*.*\n(?:template .*\n)?\\[\\[.* " +
                                     twin + "\\(");
            CHECK(std::regex_search(f.cpp, comment));
            told.insert(s->name);
        }
    }
    CHECK(told.size() > 100);
}

TEST_CASE("registry: the GLSL function is umbrage_ and the snippet's name, and a line of comment says what it does") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        const std::string function = "umbrage_" + std::string(s->name), text = s->source.str();
        CHECK(text.find(" " + function + "(") != text.npos);
        CHECK(text.find("// " + function + ": ") != text.npos);
        CHECK_FALSE(s->summary.empty());
        CHECK(s->summary.find('\n') == s->summary.npos);
    }
}

TEST_CASE("registry: a bound is stated for tiers b and c; what cannot round asks for no precision") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(((s->operations > 0) != (s->within > 0.0f)) == (s->exactness != tier::a));
        if (s->exactness == tier::a) CHECK(s->source.str().find("UMBRAGE_PRECISE") == std::string::npos);
    }
}

TEST_CASE("registry: no snippet is more exact than what it needs, nor a map's hook than the one it stands for") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(exactness({*s}) == s->exactness);
        for (const snippet* need : s->needs) {
            CAPTURE(need->name);
            CHECK(need->exactness <= s->exactness);
        }
        for (const snippet* hook : hooks::all)
            if (hook->name == s->name) {
                CAPTURE(hook->summary);
                CHECK(hook->exactness == s->exactness);
            }
    }
}
