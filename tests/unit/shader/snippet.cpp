// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <string_view>

#include <umbrage/shader/snippet.hpp>

using namespace umbrage;

TEST_CASE("fill: keys become decimal digits") {
    constexpr auto filled = glsl::detail::fill<64>("a$b, $n.0 $b$b", {{'b', 9}, {'n', 65536}});
    static_assert(filled.view() == "a9, 65536.0 99");
    static_assert(glsl::detail::fill<8>("$z", {{'z', 0}}).view() == "0");
    static_assert(glsl::detail::fill<8>("$z", {{'z', -12}}).view() == "-12");
    static_assert(glsl::detail::fill<16>("$z.$z", {{'z', 7, "one"}}).view() == "one.one");
    constexpr auto both = [] {
        auto text = glsl::detail::fill<16>("a$b", {{'b', 1}});
        text.append("c");
        return text;
    }();
    static_assert(both.view() == "a1c");
    static_assert(glsl::detail::fill<16>("$z", {{'z', 100}}).view() == "100");
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
