// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/translate/types.hpp>

using namespace umbrage::glsl::detail;

TEST_CASE("types: components and elements") {
    CHECK(width_of("vec3") == 3);
    CHECK(width_of("mat4") == 4);
    CHECK(width_of("bool") == 1);
    CHECK(component_of("ivec2") == "int");
    CHECK(component_of("uvec4") == "uint");
    CHECK(component_of("vec2") == "float");
    CHECK(component_of("bool") == "bool");
    CHECK(vector_of("uint", 3) == "uvec3");
    CHECK(vector_of("float", 1) == "float");
    CHECK(element_of("mat4") == "vec4");
    CHECK(element_of("vec4") == "float");
    CHECK(element_of("vec2[8]") == "vec2");
}

TEST_CASE("types: what an operator gives, and what GLSL does not allow without saying") {
    CHECK(type_of_product("vec2", "*", "float") == "vec2");
    CHECK(type_of_product("float", "-", "vec3") == "vec3");
    CHECK(type_of_product("int", "+", "int") == "int");
    CHECK(type_of_product("uint", ">>", "int") == "uint");
    CHECK(type_of_product("mat4", "*", "vec4") == "vec4");
    CHECK(type_of_product("vec4", "*", "mat4") == "vec4");
    CHECK(type_of_product("float", "*", "mat4") == "mat4");
    CHECK(type_of_product("int", "*", "float").empty());
    CHECK(type_of_product("vec2", "*", "vec3").empty());
    CHECK(type_of_product("vec2", "*", "int").empty());
    CHECK(type_of_product("mat4", "+", "vec4").empty());
}

TEST_CASE("types: of numbers") {
    CHECK(type_of_number("1.0") == "float");
    CHECK(type_of_number("1e5") == "float");
    CHECK(type_of_number("12") == "int");
    CHECK(type_of_number("255u") == "uint");
    CHECK(type_of_number("0xffe") == "int");
}
