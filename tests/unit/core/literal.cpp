// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include <umbrage/core/literal.hpp>

using umbrage::literal;

TEST_CASE("literal: the text that it is made of, a std::string_view to whoever reads it") {
    static_assert(literal().empty());
    static_assert(literal("rg11").size() == 4);
    static_assert(literal(std::string_view("a\0b", 3)).size() == 3);
    constexpr literal name = "rg11";
    const std::string_view view = name;
    CHECK(view == "rg11");
    CHECK(name == view);
    CHECK(std::string(name) + '!' == "rg11!");
    const std::string text = "rg12";
    const literal of_string = text;
    CHECK(of_string.data() == text.data());
}
