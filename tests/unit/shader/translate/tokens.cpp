// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/translate/tokens.hpp>

using namespace umbrage;
using glsl::detail::piece;
using strings = std::vector<std::string>;

namespace {

strings texts(std::string_view source) {
    strings all;
    for (const glsl::detail::token& t : glsl::detail::tokens(source)) all.emplace_back(t.text);
    return all;
}

}  // namespace

TEST_CASE("tokens: words, numbers and signs") {
    CHECK(texts("a+=b1.x>>2;") == strings{"a", "+=", "b1", ".", "x", ">>", "2", ";", ""});
    CHECK(texts("1.0-.5e-3+0x1E+3u") == strings{"1.0", "-", ".5e-3", "+", "0x1E", "+", "3u", ""});
    CHECK(texts("i++<-j") == strings{"i", "++", "<", "-", "j", ""});
    CHECK_THROWS_AS((void)glsl::detail::tokens("a @ b"), std::invalid_argument);
    CHECK_THROWS_AS((void)glsl::detail::tokens("a \t b"), std::invalid_argument);
}

TEST_CASE("tokens: comments and directives go to the end of their line") {
    const auto all = glsl::detail::tokens("#if A\n  x; // it is\n\n");
    REQUIRE(all.size() == 5);
    CHECK((all[0].kind == piece::directive && all[0] == "#if A"));
    CHECK((all[1].kind == piece::word && all[1].space == "\n  "));
    CHECK((all[3].kind == piece::comment && all[3] == "// it is"));
    CHECK((all[4].kind == piece::end && all[4].space == "\n\n"));
}

TEST_CASE("newest: what stands for the newest version, other directives stay") {
    std::string text;
    for (const glsl::detail::token& t :
         glsl::detail::newest(glsl::detail::tokens("a;\n#ifdef A\n#endif\n#if __VERSION__ >= 300\n    b;\n#else\n    "
                                                   "c;\n#endif\n#if __VERSION__ >= 9\nd;\n#endif\ne;\n")))
        (text += t.space) += t.text;
    CHECK(text == "a;\n#ifdef A\n#endif\n    b;\nd;\ne;\n");
}

TEST_CASE("tokens: of every snippet, nothing is lost") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = s->source.str();
        std::string again;
        for (const glsl::detail::token& t : glsl::detail::tokens(text)) (again += t.space) += t.text;
        CHECK(again == text);
    }
}

TEST_CASE("closing: the bracket that belongs to one") {
    const auto all = glsl::detail::tokens("f(a[(b)], c) + (d");
    CHECK(glsl::detail::closing(all, 1) == 10);
    CHECK(glsl::detail::closing(all, 3) == 7);
    CHECK_THROWS_AS((void)glsl::detail::closing(all, 12), std::invalid_argument);
}
