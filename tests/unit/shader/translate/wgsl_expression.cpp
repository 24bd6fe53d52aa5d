// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/shader/translate/wgsl_expression.hpp>

using umbrage::wgsl::detail::expressions;
using umbrage::wgsl::detail::signatures;

namespace {

std::string wgsl_expression(const std::string& glsl, const std::string& type = "") {
    const signatures functions{{"f", "f", "float,", "float"}, {"f", "f_vec2f", "vec2,", "vec2"}};
    expressions e(glsl, functions);
    e.variables = {{"a", "float"}, {"b", "float"}, {"v", "vec2"}, {"i", "int"},
                   {"j", "int"},   {"u", "uint"},  {"m", "mat4"}, {"all", "float[4]"}};
    const auto printed = e.expression();
    if (e.next().kind != umbrage::glsl::detail::piece::end) throw std::invalid_argument("more behind it");
    if (!type.empty()) CHECK(printed.type == type);
    return printed.text;
}

}  // namespace

TEST_CASE("wgsl_expression: ?: is select, nested without brackets of its own") {
    CHECK(wgsl_expression("a > b ? a : b", "float") == "select(b, a, a > b)");
    CHECK(wgsl_expression("a > b ? a : (a < 1.0 ? 1.0 : (b))", "float") ==
          "select(select((b), 1.0, a < 1.0), a, a > b)");
    CHECK(wgsl_expression("(a > b ? a : b) * 2.0", "float") == "select(b, a, a > b) * 2.0");
    CHECK(wgsl_expression("a > b ? a < b : true", "bool") == "select(true, (a < b), a > b)");
}

TEST_CASE("wgsl_expression: conversions that GLSL leaves unsaid are written") {
    CHECK(wgsl_expression("vec2(i, a)", "vec2") == "vec2f(f32(i), a)");
    CHECK(wgsl_expression("vec2(1, a)", "vec2") == "vec2f(1, a)");
    CHECK(wgsl_expression("vec2(a)", "vec2") == "vec2f(a)");
    CHECK(wgsl_expression("ivec2(v)", "ivec2") == "vec2i(v)");
    CHECK(wgsl_expression("float(i)", "float") == "f32(i)");
    CHECK(wgsl_expression("max(v, 1.0)", "vec2") == "max(v, vec2f(1.0))");
    CHECK(wgsl_expression("clamp(v, vec2(0.0, 0.0), v - 1.0)", "vec2") == "clamp(v, vec2f(0.0, 0.0), v - 1.0)");
    CHECK(wgsl_expression("u >> i", "uint") == "u >> u32(i)");
    CHECK(wgsl_expression("uintBitsToFloat(u)", "float") == "bitcast<f32>(u)");
    CHECK(wgsl_expression("m[3] + m[0] * v.x", "vec4") == "m[3] + m[0] * v.x");
    CHECK(wgsl_expression("m * vec4(v, a, b)", "vec4") == "m * vec4f(v, a, b)");
}

TEST_CASE("wgsl_expression: operators that WGSL has on one level are bracketed") {
    CHECK(wgsl_expression("u >> 8 & 255u", "uint") == "(u >> 8) & 255u");
    CHECK(wgsl_expression("u & 1u | u & 2u | 4u", "uint") == "(u & 1u) | (u & 2u) | 4u");
    CHECK(wgsl_expression("i + j << 2", "int") == "(i + j) << 2");
    CHECK(wgsl_expression("a > b && i == j || !(a < 1.0)", "bool") == "(a > b && i == j) || !(a < 1.0)");
    CHECK(wgsl_expression("a < b == true", "bool") == "(a < b) == true");
    CHECK(wgsl_expression("a - -b * 2.0", "float") == "a - -b * 2.0");
}

TEST_CASE("wgsl_expression: components, elements and calls") {
    CHECK(wgsl_expression("all[i + 1] * m[3].x", "float") == "all[i + 1] * m[3].x");
    CHECK(wgsl_expression("vec4(v, v).xyz", "vec3") == "vec4f(v, v).xyz");
    CHECK(wgsl_expression("f(a) + f(v).x", "float") == "f(a) + f_vec2f(v).x");
    CHECK(wgsl_expression("f( v * 2.0 )", "vec2") == "f_vec2f( v * 2.0 )");
    CHECK(wgsl_expression("UMBRAGE_TEXEL.x", "float") == "UMBRAGE_TEXEL.x");
}

TEST_CASE("wgsl_expression: what it does not know, it refuses") {
    for (const std::string unknown :
         {"c", "g(a)", "gl_FragCoord.x", "texture2D(a, v)", "a + i", "v.s", "v == v ? a : b", "a ? a : b", "mod(a, b)",
          "a > b ? a : v", "umbrage_g(a)", "a + // why\n b", "floatBitsToUint(v)", "max(v, i)", "!", "(a", "f(a, b)",
          "f(i)"}) {
        CAPTURE(unknown);
        CHECK_THROWS_AS(wgsl_expression(unknown), std::invalid_argument);
    }
}
