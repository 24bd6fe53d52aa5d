// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/shader/translate/wgsl_function.hpp>

namespace {

std::string printed(std::string_view glsl) {
    umbrage::wgsl::detail::signatures functions;
    umbrage::wgsl::detail::printer(glsl, functions).declare();
    return umbrage::wgsl::detail::printer(glsl, functions).print();
}

/// The same of statements on floats a and b, a vec2 v and an int i.
std::string inside(const std::string& statements) {
    const std::string text =
        printed("float f(float a, float b, vec2 v, int i) {\n" + statements + "\n    return a;\n}\n");
    const std::string head = "fn f(a: f32, b: f32, v: vec2f, i: i32) -> f32 {\n", tail = "\n    return a;\n}\n";
    REQUIRE(text.starts_with(head));
    REQUIRE(text.ends_with(tail));
    return text.substr(head.size(), text.size() - head.size() - tail.size());
}

}  // namespace

TEST_CASE("wgsl_function: overloads have a type in their name, and calls find it") {
    CHECK(printed("float f(float a) {\n    return a;\n}\n"
                  "vec2 f(vec2 a) {\n    return a;\n}\n"
                  "vec3 g(vec2 a) {\n    return vec3(f(a.x), f(a * 2.0));\n}\n") ==
          "fn f(a: f32) -> f32 {\n    return a;\n}\n"
          "fn f_vec2f(a: vec2f) -> vec2f {\n    return a;\n}\n"
          "fn g(a: vec2f) -> vec3f {\n    return vec3f(f(a.x), f_vec2f(a * 2.0));\n}\n");
}

TEST_CASE("wgsl_function: variables are let or var, and parameters that are assigned to are copied") {
    CHECK(inside("    float x = a;") == "    let x: f32 = a;");
    CHECK(inside("    float x = a;\n    x += b;") == "    var x: f32 = a;\n    x += b;");
    CHECK(inside("    vec2 x = v;\n    x.y = b;") == "    var x: vec2f = v;\n    x.y = b;");
    CHECK(inside("    int x;\n    ++x;") == "    var x: i32;\n    x++;");
    CHECK(inside("    float x[4];\n    x[i] = a;") == "    var x: array<f32, 4>;\n    x[i] = a;");
    CHECK(inside("    const float x = 0.5;") == "    const x: f32 = 0.5;");
    CHECK(inside("    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = a;") == "    let x: f32 = a;");
    CHECK(printed("float f(float a, float b) {\n    a *= b;\n    return a;\n}\n") ==
          "fn f(a_in: f32, b: f32) -> f32 {\n    var a: f32 = a_in;\n    a *= b;\n    return a;\n}\n");
}

TEST_CASE("wgsl_function: branches and loops have braces") {
    CHECK(inside("    float x = 0.0;\n    if (a > b) x = a; else if (i < 2) { x = b; }\n    else\n        x = 1.0;") ==
          "    var x: f32 = 0.0;\n    if (a > b) { x = a; } else if (i < 2) { x = b; }\n    else {\n        x = 1.0;\n"
          "    }");
    CHECK(inside("    float x = 0.0;\n    for (int k = 0; k < 4; k++)\n        x += float(k);") ==
          "    var x: f32 = 0.0;\n    for (var k: i32 = 0; k < 4; k++) {\n        x += f32(k);\n    }");
    CHECK(inside("    for (int k = 0; k < 4; k++) {\n        if (k > i) break;  // enough\n    }") ==
          "    for (var k: i32 = 0; k < 4; k++) {\n        if (k > i) { break; }  // enough\n    }");
}

TEST_CASE("wgsl_function: comments stay where they are, between statements") {
    const std::string_view text =
        "\n// f: what it does\nfn f(a: f32) -> f32 {\n    // first\n    return a;  // last\n}\n";
    CHECK(printed("\n// f: what it does\nfloat f(float a) {\n    // first\n    return a;  // last\n}\n") == text);
}

TEST_CASE("wgsl_function: what it does not know, it refuses") {
    CHECK_THROWS_AS(printed("#define a b\nfloat f() {\n    return 1.0;\n}\n"), std::invalid_argument);
    CHECK_THROWS_AS(printed("float f() {\n    return 1.0;\n"), std::invalid_argument);
    CHECK_THROWS_AS(printed("double f() {\n    return 1.0;\n}\n"), std::invalid_argument);
    CHECK_THROWS_AS(printed("float f(out float a) {\n    return 1.0;\n}\n"), std::invalid_argument);
    for (const std::string unknown :
         {"while (a > b) a;", "discard;", "a;", "a == b;", "float if = a;", "vec2 x = a;", "if (a) i = 1;"}) {
        CAPTURE(unknown);
        CHECK_THROWS_AS(inside(unknown), std::invalid_argument);
    }
}
