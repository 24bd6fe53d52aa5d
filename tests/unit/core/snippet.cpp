// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <string>
#include <string_view>

#include <umbrage/core/snippet.hpp>

using namespace umbrage;

TEST_CASE("filled: keys become decimal digits") {
    using glsl::detail::filled;
    CHECK(filled("a$b, $n.0 $b$b", {{'b', 9}, {'n', 65536}}) == "a9, 65536.0 99");
    CHECK(filled("$z", {{'z', 0}}) == "0");
    CHECK(filled("$z", {{'z', -12}}) == "-12");
    CHECK(filled("$z.$z", {{'z', 7, "one"}}) == "one.one");
    CHECK(filled("$z", {{'z', 7, ""}}) == "");
    CHECK(filled("$z", {{'z', 100}}) == "100");
}

TEST_CASE("short_name: the same at compile time") {
    constexpr glsl::detail::short_name name("decode_rg$b", {{'b', 16}});
    static_assert(name.view() == "decode_rg16");
}

TEST_CASE("snippet_text: written down, or put together when it is asked for") {
    constexpr glsl::snippet_text written("\nfloat f;\n"), made([] { return glsl::detail::filled("$n", {{'n', 5}}); });
    CHECK(written.str() == "\nfloat f;\n");
    CHECK(made.str() == "5");
}

TEST_CASE("directive: every dialect has one, Vulkan's is that of 450") {
    std::set<std::string_view> directives;
    for (glsl::version v : glsl::versions) directives.insert(directive(v));
    CHECK(directives.size() == glsl::versions.size() - 1);
    CHECK_FALSE(directives.contains(""));
}

TEST_CASE("snippets are told apart by their names") {
    constexpr glsl::snippet a{.name = "a", .source = "\n"}, b{.name = "b", .source = "\n"};
    CHECK(a == a);
    CHECK_FALSE(a == b);
}
