// SPDX-License-Identifier: MIT
//
// Names and texts that are written down: a std::string_view, but for what it costs to compile. That one counts its
// characters one by one, by calls that the compiler evaluates.
//
//     static constexpr umbrage::literal name = "rg11";
//
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/config.hpp>

namespace umbrage {

struct literal : std::string_view {
    constexpr literal() = default;
    constexpr literal(const char* text) : std::string_view(text, detail::length(text)) {}
    constexpr literal(std::string_view text) : std::string_view(text) {}
    constexpr literal(const std::string& text) : std::string_view(text) {}
};

}  // namespace umbrage
