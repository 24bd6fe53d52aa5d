// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>

#include <umbrage/registry.hpp>
#include <umbrage/shader/translate/layout.hpp>

using namespace umbrage;
using glsl::detail::laid_out;

TEST_CASE("laid_out: lines that have room for the next take it") {
    CHECK(laid_out("float f(float a,\n        float b) {\n    float c =\n        a + b;\n    return c;\n}\n") ==
          "float f(float a, float b) {\n    float c = a + b;\n    return c;\n}\n");
    CHECK(laid_out("    f(\n        a);\n") == "    f(a);\n");
}

TEST_CASE("laid_out: lines that have not are broken after a comma or an operator, below their bracket") {
    const std::string a(50, 'a'), b(60, 'b'), c(8, 'c');
    CHECK(laid_out("    f(" + a + ", g(" + c + "), " + b + ");\n") ==
          "    f(" + a + ", g(" + c + "),\n      " + b + ");\n");
    const std::string d(52, 'd');
    CHECK(laid_out("    x = g(" + a + ", h(" + c + ",\n" + d + "));\n") ==
          "    x =\n        g(" + a + ",\n          h(" + c + ", " + d + "));\n");
    CHECK(laid_out("    " + a + " =\n    " + b + " +\n    " + c + ";\n") ==
          "    " + a + " = " + b + " +\n        " + c + ";\n");
}

TEST_CASE("laid_out: lines are broken as far out of brackets as may be, and comments behind them are not") {
    const std::string a(30, 'a'), b(30, 'b');
    CHECK(laid_out("    return (f(" + a + ", " + b + ") + f(" + a + ", " + b + ")) * 0.25;  // a, " + a + "\n") ==
          "    return (f(" + a + ", " + b + ") +\n            f(" + a + ", " + b + ")) * 0.25;  // a, " + a + "\n");
}

TEST_CASE("laid_out: what fills a line to the last column stays whole") {
    const std::string a(57, 'a'), b(57, 'b');
    CHECK(laid_out("f(" + a + ", " + b + ");\n") == "f(" + a + ", " + b + ");\n");  // 120
    CHECK(laid_out("f(" + a + ", " + b + "b);\n") == "f(" + a + ",\n  " + b + "b);\n");
}

TEST_CASE("laid_out: comments, directives and empty lines stay") {
    const std::string text = "\n// a,\n// b\n#if c\n\nx;  // d,\ny;\n#endif\n";
    CHECK(laid_out(text) == text);
    CHECK(laid_out("x") == "x\n");
}

TEST_CASE("laid_out: of every snippet, only white space changes, and what is laid out stays") {
    const auto bare = [](std::string text) {
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
    };
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = s->source.str();
        const std::string once = laid_out(text);
        CHECK(bare(once) == bare(text));
        CHECK(laid_out(once) == once);
    }
}
