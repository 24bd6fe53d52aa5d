// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include "literals.hpp"

using namespace turned;

namespace {

/// Numbers of code, each with the reason why it stays.
std::string found_in(std::string_view code) {
    std::string all;
    for (const literal& l : literals_of(code, tokens_of(code)))
        all += std::string(code.substr(l.at, l.size)) + ':' + std::string(name_of(l.why)) + ' ';
    return all;
}

/// Code without each of its fields in turn.
std::string without_each(std::string_view code) {
    std::string all;
    for (const field& f : fields_of(code, tokens_of(code)))
        all += std::string(code.substr(0, f.at)) + std::string(code.substr(f.at + f.size)) + " | ";
    return all;
}

}  // namespace

TEST_CASE("literals: every form of a number is one token") {
    CHECK(found_in("a = 1 + 2.5f - .5 * 1e-3 / 0x1p-20f + 1'000u;") ==
          "1:turned 2.5f:turned .5:turned 1e-3:turned 0x1p-20f:turned 1'000u:turned ");
    CHECK(found_in("vec3 v1{x2, y_3};").empty());
}

TEST_CASE("literals: none in text, comments and directives") {
    CHECK(found_in("#include <a/12.hpp>\n f(\"7 \\\" 8\", '9', R\"(10 \" 11)\", R\"GLSL(12)GLSL\"); // 13\n/* 14 */")
              .empty());
}

TEST_CASE("literals: none in template arguments, all in comparisons") {
    CHECK(found_in("f<3>(1), rg<11>{}, a<b<4>, 5>::c") == "1:turned ");
    CHECK(found_in("if (i < 4 && j > 5) g(x<y);") == "4:turned 5:turned ");
}

TEST_CASE("literals: loops, subscripts, constants and output stay") {
    CHECK(found_in("for (int i = 0; i < 8; ++i) f(1);") == "0:loop 8:loop 1:turned ");
    CHECK(found_in("a[2] = b[3][4]; auto l = [&] { return 5; }; float m[16]{6};") ==
          "2:subscript 3:subscript 4:subscript 5:turned 16:subscript 6:turned ");
    CHECK(found_in("constexpr int a = f({1, 2}); b = 3;") == "1:constant 2:constant 3:turned ");
    CHECK(found_in("std::printf(\"%d\", f({1}, 2)); g(3);") == "1:output 2:output 3:turned ");
}

TEST_CASE("fields: each goes with a comma that separates it, and with fields of its own") {
    CHECK(without_each("f({.a = 1, .b = g(2, {3}), .c = x});") ==
          "f({ .b = g(2, {3}), .c = x}); | f({.a = 1,  .c = x}); | f({.a = 1, .b = g(2, {3})}); | ");
    CHECK(without_each("f({.a = {.b = 1}});") == "f({}); | f({.a = {}}); | ");
    CHECK(without_each("f({.a = 1,});") == "f({}); | ");
}

TEST_CASE("fields: none in assignments, comparisons, text and constants") {
    CHECK(without_each("x.a = 1; if (x.a == 1) f(\"{.a = 1}\");").empty());
    CHECK(without_each("constexpr light a{.b = 1}; light c{.d = 2};") == "constexpr light a{.b = 1}; light c{}; | ");
}

TEST_CASE("enumerators: each goes to each other value of its enumeration, with its namespaces") {
    const std::string_view code =
        "f(glsl::texture::depth, a.depth, version::v330, 1, umbrage::cpu_clip_space); texture::own();";
    std::string all;
    for (const literal& l : literals_of(code, tokens_of(code)))
        all += std::string(code.substr(l.at, l.size)) + ':' + std::to_string(l.others.size()) + ' ';
    CHECK(all == "glsl::texture::depth:9 version::v330:12 1:0 umbrage::cpu_clip_space:9 ");
    CHECK(found_in("a = handedness::left; b.outside = umbrage::outside_map::clamped;") ==
          "handedness::left:turned umbrage::outside_map::clamped:turned ");
}

TEST_CASE("enumerators: constants stay, and none is in template arguments") {
    CHECK(found_in("constexpr auto a = depth_direction::forward; f<depth_direction::forward>(a);") ==
          "depth_direction::forward:constant ");
}
