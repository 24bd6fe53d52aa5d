// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>

#include "parts_of_text.hpp"

using namespace umbrage::glsl;

namespace {

constexpr snippet leaf{.name = "leaf", .summary = "", .source = "\nfloat umbrage_leaf() { return 1.0; }\n"};
constexpr snippet left{.name = "left", .summary = "", .needs = list<&leaf>, .source = "\nleft body\n"};
constexpr snippet right{.name = "right", .summary = "", .needs = list<&leaf>, .source = "\nright body\n"};
constexpr snippet top{.name = "top", .summary = "", .needs = list<&left, &right>, .source = "\ntop body\n"};
constexpr snippet wide{
    .name = "wide", .summary = "", .needs = list<&top, &right, &left, &leaf, &leaf, &top>, .source = "\nwide body\n"};
constexpr snippet modern{.name = "modern", .summary = "", .lowest = version::v300_es, .source = "\nmodern body\n"};

std::string without_comments(std::string_view text) {
    std::string out;
    bool comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        comment = text[i] == '\n' ? false : comment || text.substr(i, 2) == "//";
        if (!comment) out += text[i];
    }
    return out;
}

struct word {
    std::string_view text;
    bool member;  ///< follows a dot
};

std::vector<word> words(std::string_view code) {
    const auto part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::vector<word> found;
    for (std::size_t i = 0; i < code.size();) {
        if (!part(code[i])) {
            ++i;
            continue;
        }
        const auto start = i;
        while (i < code.size() && part(code[i])) ++i;
        if (!std::isdigit(static_cast<unsigned char>(code[start])))
            found.push_back({code.substr(start, i - start), start > 0 && code[start - 1] == '.'});
    }
    return found;
}

/// Texts that the preprocessor may leave, without directives: with the first branch of every #if, and with the last.
std::vector<std::string> branches(const std::string& code) {
    std::vector<std::string> texts;
    for (const bool first : {true, false}) {
        std::vector<bool> taken;
        std::istringstream lines(code);
        std::string& text = texts.emplace_back();
        for (std::string line; std::getline(lines, line);) {
            if (line.starts_with("#if")) taken.push_back(first);
            else if (line.starts_with("#el")) taken.back() = !first;
            else if (line.starts_with("#endif")) taken.pop_back();
            else if (!line.starts_with("#") && std::find(taken.begin(), taken.end(), false) == taken.end())
                text += line + '\n';
        }
    }
    return texts;
}

/// Functions that have not exactly one return, their last statement.
std::vector<std::string> several_exits(const std::string& code) {
    std::vector<std::string> found;
    std::size_t depth = 0, start = 0, head = 0;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == '{' && depth++ == 0) start = i + 1;
        if (code[i] != '}' || --depth != 0) continue;
        const std::string body = ';' + code.substr(start, i - start);
        const auto exit = body.find("return "), before = body.find_last_not_of(" \n", exit - 1);
        const bool once = exit != body.npos && body.find("return", exit + 1) == body.npos;
        const bool after_statement = once && (body[before] == ';' || body[before] == '}');
        if (!after_statement || body.find_first_not_of(" \n", body.find(';', exit) + 1) != body.npos)
            found.push_back(code.substr(head, start - head));
        head = i + 1;
    }
    return found;
}

/// A scan that finds nothing proves nothing: what the rules below rest on, tried on a text that breaks them.
const std::string bad = without_comments("a__b gl_x v.xy // mix(\nmix (1.0) c.x 2.5e3");

}  // namespace

TEST_CASE("the scan that the rules rest on sees what it should") {
    std::string all;
    for (const word& w : words(bad)) all += std::string(w.text) + (w.member ? "! " : " ");
    CHECK(all == "a__b gl_x v xy! mix c x! ");

    const std::string forked = "float f() {\n#if A\n    return 1.0;\n#else\n    return 2.0;\n#endif\n}\n";
    for (const std::string& text : branches(forked)) CHECK(several_exits(text).empty());
    CHECK(branches(forked)[0] != branches(forked)[1]);
    const std::string other = " float g() { return 0.0; } ";
    for (const char* body : {"{ return 1.0; }", "{ if (a) { b; } return 1.0; }", "{\n    a;\n    return b;\n}\n"})
        CHECK(several_exits("float f() " + std::string(body)).empty());
    for (const char* body :
         {"{ if (a) return 1.0; return 2.0; }", "{ return 1.0; a; }", "{ a; }", "{ }", "{ if (a) { return 1.0; } }",
          "{ if (a) return 1.0; }", "{ for (;;) { return 1.0; } return 2.0; }"})
        CHECK(several_exits(other + "float f() " + body + other).size() == 1);
}

TEST_CASE("text: what is needed comes before, each once") {
    const std::string out = text({top, leaf, right, top});
    for (std::string_view part : {"umbrage_leaf()", "left body", "right body", "top body"})
        CHECK(count(out, part) == 1);
    CHECK(out.find("umbrage_leaf()") < out.find("left body"));
    CHECK(out.find("left body") < out.find("right body"));
    CHECK(out.find("right body") < out.find("top body"));
    CHECK(out.starts_with("// umbrage 0.1.0, MIT License: top, leaf, right\n" + std::string(prelude)));
    CHECK(count(out, "#ifndef UMBRAGE_HAS_LEFT\n#define UMBRAGE_HAS_LEFT\n") == 1);
    CHECK(count(out, "#if") == count(out, "#endif"));
    CHECK(text(std::vector<bound>()) == "// umbrage 0.1.0, MIT License\n" + std::string(prelude));
    CHECK(count(text({wide}), "body") == 4);
}

TEST_CASE("source: #version first, then the preamble on lines of its own, then the snippets") {
    CHECK(source(version::v100, {leaf}) == "#version 100\n" + text({leaf}, version::v100));
    CHECK(source(version::v300_es, {leaf}, "precision highp float;") ==
          "#version 300 es\nprecision highp float;\n" + text({leaf}, version::v300_es));
    CHECK(source(version::vulkan, {leaf}, "#define A\n") ==
          "#version 450\n#define A\n" + text({leaf}, version::vulkan));
    std::set<std::string_view> directives;
    for (version v : versions) directives.insert(directive(v));
    CHECK(directives.size() == versions.size() - 1);  // Vulkan's is that of 450
    CHECK_FALSE(directives.contains(""));
}

TEST_CASE("source: a dialect that a snippet does not support") {
    for (version v : versions) {
        CHECK(supports(leaf, v));
        const bool old =
            v == version::v100 || v == version::v110 || v == version::v120 || v == version::v130 || v == version::v150;
        CHECK(supports(modern, v) == !old);
        if (old) CHECK_THROWS_AS((void)source(v, {leaf, modern}), std::invalid_argument);
        else CHECK_NOTHROW((void)source(v, {leaf, modern}));
    }
}

TEST_CASE("registry: names tell snippets apart, and whatever one needs is there and old enough") {
    std::set<std::string_view> names;
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        CHECK(names.insert(s->name).second);
        CHECK_FALSE(s->summary.empty());
        CHECK((s->exactness == tier::a ? s->operations == 0 && s->within == 0.0f
                                       : (s->operations > 0) != (s->exactness == tier::c && s->within > 0.0f)));
        CHECK(count(s->source.str(), "umbrage_" + std::string(s->name) + "(") > 0);
        CHECK(count(s->source.str(), "// umbrage_" + std::string(s->name) + ":") ==
              1);  // a copied text explains itself
        for (const snippet* need : s->needs) {
            CAPTURE(need->name);
            CHECK(std::find(registry().begin(), registry().end(), need) != registry().end());
            for (version v : versions) CHECK((!supports(*s, v) || supports(*need, v)));
            CHECK(count(without_comments(s->source.str()), "umbrage_" + std::string(need->name) + "(") > 0);
        }
    }
}

TEST_CASE("registry: every function of the library that a snippet calls is among its needs") {
    for (const snippet* s : registry()) {
        const std::string out = text({*s}), code = without_comments(out);
        for (const word& w : words(code))
            if (w.text.starts_with("umbrage_")) {
                CAPTURE(s->name);
                CAPTURE(w.text);
                bool defined = false;
                for (std::string_view type : {"bool", "float", "vec2", "vec3", "vec4", "mat4"})
                    defined = defined || count(out, std::string(type) + " " + std::string(w.text) + "(") > 0;
                CHECK(defined);
            }
    }
}

TEST_CASE("registry: texts that every compiler takes and any host shader can carry") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        const std::string text = s->source.str();
        CHECK(text.size() < 12000);
        CHECK(text.starts_with("\n//"));
        CHECK(text.ends_with("\n"));
        CHECK(std::all_of(text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
        CHECK(text.find('$') == text.npos);  // a key of the family left over
        const std::string code = without_comments(text);
        CHECK(count(code, "#version") == 0);
        CHECK(count(code, "#if") == count(code, "#endif"));
        for (const word& w : words(code)) {
            CAPTURE(w.text);
            CHECK((w.text == "__VERSION__" || w.text.find("__") == w.text.npos));
            CHECK_FALSE(w.text.starts_with("gl_"));
            for (std::string_view never :
                 {"precision", "uniform", "layout", "varying", "attribute", "out", "inout", "while"})
                CHECK(w.text != never);
            if (w.member) CHECK(w.text.size() == 1);  // no swizzles of several components
            if (s->exactness == tier::c) continue;
            for (std::string_view loose : {"mix", "dot", "fma", "round", "mod", "fract", "smoothstep"})
                CHECK((w.text != loose ||
                       (loose == "fract" && s == &umbrage::glsl::page_coordinate)));  // of a product that is exact
        }
    }
}

// What a shader hands on in mediump, as GLSL ES 1.00 has gl_FragColor, may be rounded to 16 bits. Mesa drops the
// rounding where it stands next to the store; where a value comes out of a branch it rounds in the branch, and there it
// stays. So a sum lost bits behind an early return before its loop that one return of a selection keeps. Nor do fetches
// wait for a branch then.
TEST_CASE("registry: one exit a function, its last statement") {
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        const std::string text = s->source.str();
        for (const std::string& branch : branches(without_comments(text)))
            for (const std::string& function : several_exits(branch)) {
                CAPTURE(function);
                CHECK(false);
            }
    }
}

TEST_CASE("registry: a division or a root is tier C, but for one mended") {
    for (const snippet* s : registry()) {
        if (s->exactness == tier::c || s == &umbrage::glsl::floor_divide) continue;
        CAPTURE(s->name);
        const std::string code = without_comments(s->source.str());
        for (std::string_view loose : {"sqrt(", "normalize(", "length(", "pow(", "exp2(", "exp(", "sin(", "cos("})
            CHECK(count(code, loose) == 0);
        for (auto at = code.find(" / "); at != code.npos; at = code.find(" / ", at + 1)) {
            const bool constant = std::isdigit(static_cast<unsigned char>(code[at - 1])) &&
                                  std::isdigit(static_cast<unsigned char>(code[at + 3]));
            CHECK(constant);
        }
    }
}

TEST_CASE("registry: highp on every parameter, local and return; int is wide enough anywhere for what it counts") {
    const std::set<std::string_view> types{"float", "vec2", "vec3", "vec4", "mat3", "mat4", "uint", "uvec4"};
    for (const snippet* s : registry()) {
        CAPTURE(s->name);
        const std::string code = without_comments(s->source.str());
        const auto all = words(code);
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            if (!types.contains(all[i].text)) continue;
            const auto* after = all[i].text.data() + all[i].text.size();
            if (*after != ' ') continue;  // a constructor
            CAPTURE(all[i + 1].text);
            CHECK(i > 0);
            CHECK(all[i - 1].text == "UMBRAGE_HIGHP");
        }
    }
}
