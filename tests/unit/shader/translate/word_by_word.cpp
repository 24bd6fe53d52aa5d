// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/shader/translate/word_by_word.hpp>

using namespace umbrage::glsl::detail;

namespace {

/// With everything that a language can do differently.
constexpr near_language other{.name = "other",
                              .own = &word::hlsl,
                              .precise = "exactly",
                              .function = "a ",
                              .condition = "sharp ",
                              .matrices_have_rows = true,
                              .vectors_of_one_are_cast = true,
                              .reserved = " sample "};
/// As GLSL does it.
constexpr near_language alike{.name = "alike",
                              .own = &word::msl,
                              .precise = "",
                              .function = "",
                              .condition = "",
                              .matrices_have_rows = false,
                              .vectors_of_one_are_cast = false,
                              .reserved = {}};

std::string print(std::string_view text, const near_language& language = other) {
    return word_by_word(language, text).print();
}

/// `expression` of x, a vec2, and m, a mat4.
std::string expression(const std::string& text, const near_language& language = other) {
    const std::string printed = print("float f(vec2 x, mat4 m) { return " + text + "; }", language);
    const auto begin = printed.find("return ") + 7;
    return printed.substr(begin, printed.size() - 3 - begin);
}

}  // namespace

TEST_CASE("word_by_word: names, comments and layout stay, words and qualifiers go") {
    CHECK(print(R"(
// f: vec2 in, vec2 out
UMBRAGE_HIGHP vec2 umbrage_f(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size,
                             int count) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 sum = size * 2.0;  // vec2
    for (int i = 0; i < 4; i++) sum += fract(size);
    return sum;
}
)") == R"(
// f: vec2 in, vec2 out
a float2 umbrage_f(UMBRAGE_MAP map, float2 size,
                             int count) {
    exactly float2 sum = size * 2.0;  // vec2
    for (int i = 0; i < 4; i++) sum += frac(size);
    return sum;
}
)");
}

TEST_CASE("word_by_word: vectors of one value are cast, and only those") {
    CHECK(expression("vec4(x.y)") == "(float4)x.y");
    CHECK(expression("vec4(x.y + 1.0)") == "(float4)(x.y + 1.0)");
    CHECK(expression("vec4(umbrage_g(x, 1.0))") == "(float4)umbrage_g(x, 1.0)");
    CHECK(expression("vec2(1.0).y") == "((float2)1.0).y");
    CHECK(expression("ivec2(vec2(x.x, 1.0))") == "(int2)float2(x.x, 1.0)");
    CHECK(print("bool f(bool a) { return a; }") == "a sharp bool f(bool a) { return a; }");
    CHECK(expression("float(x.y)") == "float(x.y)");
    CHECK(expression("vec4(x.y)", alike) == "float4(x.y)");
}

TEST_CASE("word_by_word: columns of a matrix") {
    CHECK(expression("m[3] * x.y") == "transpose(m)[3] * x.y");
    CHECK(expression("x[1]") == "x[1]");
    CHECK(expression("umbrage_g(mat4(x, x, x, x))") == "umbrage_g(transpose(float4x4(x, x, x, x)))");
    CHECK(expression("m[3] * x.y", alike) == "m[3] * x.y");
    CHECK_THROWS_AS((void)expression("m * x"), std::invalid_argument);
    CHECK_THROWS_AS((void)expression("x * m"), std::invalid_argument);
    CHECK_THROWS_AS((void)expression("mat4(1.0)"), std::invalid_argument);
}

TEST_CASE("word_by_word: what a map fills in stays") {
    CHECK(expression("UMBRAGE_TEXEL.x + UMBRAGE_DEPTH") == "UMBRAGE_TEXEL.x + UMBRAGE_DEPTH");
    CHECK_THROWS_AS((void)expression("UMBRAGE_OTHER"), std::invalid_argument);
}

TEST_CASE("word_by_word: words that it does not know") {
    for (const char* text :
         {"y", "mod(x, 2.0)", "floor", "x.s", "x.xyz1", "texture2D(x, x)", "sample2D", "g(x)", "while"}) {
        CAPTURE(text);
        CHECK_THROWS_AS((void)expression(text), std::invalid_argument);
    }
    CHECK_THROWS_WITH((void)expression("mod(x, 2.0)"),
                      "umbrage::other::text: source must be of words that the language has; got \"mod\"");
    CHECK_THROWS_AS((void)print("#if A\n"), std::invalid_argument);
    CHECK_THROWS_AS((void)print("float f(float sample) { return sample; }"), std::invalid_argument);
    CHECK_NOTHROW((void)print("float f(float sample) { return sample; }", alike));
    CHECK_THROWS_AS((void)print("float f(float a) { return a; }\nfloat g(float b) { return a; }"),
                    std::invalid_argument);
}
