// SPDX-License-Identifier: MIT
//
// Errors for bad input. All messages have one form: function, argument, condition, value and usual cause.
//
//     detail::require(map_size >= 1, "make_cascades", "map_size", "above 0", map_size);
//     // umbrage::make_cascades: map_size must be above 0; got 0
//
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>

namespace umbrage::detail {

/// Text of a value in an error message. This library's own words stay bare ("none"), and callers' text gets quotes.
[[nodiscard]] inline std::string printed(const char* words) { return words; }
[[nodiscard]] inline std::string printed(std::string_view text) { return std::string("\"").append(text).append("\""); }
template <class T>
requires std::is_arithmetic_v<T>
[[nodiscard]] std::string printed(T number) {
    if constexpr (std::is_same_v<T, bool>) return number ? "true" : "false";
    else if constexpr (std::is_integral_v<T>) return std::to_string(number);
    else {
        char text[32];
        std::snprintf(text, sizeof text, "%g", static_cast<double>(number));
        return text;
    }
}

/// Text of a vector: sizes print as "640 x 480", other vectors as "(1, 0.5, 0)". A matrix prints as its columns.
template <glm::length_t N, class T>
[[nodiscard]] std::string printed(const glm::vec<N, T>& v) {
    constexpr bool size = std::is_same_v<glm::vec<N, T>, glm::ivec2>;
    std::string text = size ? "" : "(";
    for (glm::length_t i = 0; i < N; ++i) text.append(i == 0 ? "" : size ? " x " : ", ").append(printed(v[i]));
    return text.append(size ? "" : ")");
}
template <glm::length_t Columns, glm::length_t Rows, class T>
[[nodiscard]] std::string printed(const glm::mat<Columns, Rows, T>& m) {
    std::string text;
    for (glm::length_t i = 0; i < Columns; ++i) text.append(i == 0 ? "(" : ", ").append(printed(m[i]));
    return text.append(")");
}

/// Reports a wrong argument, or several: "umbrage::function: argument must be condition; got value. Cause".
/// @param got     value of the argument, see printed
/// @param cause   the usual cause, or the remedy; may be empty
/// @throws std::invalid_argument   always, see fail
template <class Value>
[[noreturn]] void refuse(std::string_view function, std::string_view argument, std::string_view condition,
                         const Value& got, std::string_view cause = {}) {
    const std::string value = printed(got);
    std::string message = "umbrage::";  // append() instead of +, which GCC 12 sometimes suspects of an overrun
    for (const std::string_view part : {function, std::string_view(": "), argument, std::string_view(" must be "),
                                        condition, std::string_view("; got "), std::string_view(value)})
        message.append(part);
    if (!cause.empty()) message.append(". ").append(cause);
    fail(message);
}

/// Reports a wrong argument unless the condition is met.
template <class Value>
constexpr void require(bool met, std::string_view function, std::string_view argument, std::string_view condition,
                       const Value& got, std::string_view cause = {}) {
    if (!met) refuse(function, argument, condition, got, cause);
}

/// Reports an image of a wrong size.
/// @param whose   name of the wanted size, such as "the receivers' size"
inline void require_size(glm::ivec2 got, glm::ivec2 wanted, std::string_view function, std::string_view argument,
                         std::string_view whose) {
    if (got != wanted) refuse(function, argument, std::string(whose).append(", ").append(printed(wanted)), got);
}

}  // namespace umbrage::detail
