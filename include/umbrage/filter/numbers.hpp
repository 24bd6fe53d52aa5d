// SPDX-License-Identifier: MIT
//
// Numbers of a filter: what its snippet's function takes after coordinate and receiver. A filter states them once, and
// their types are those of its members.
//
//     static constexpr auto numbers(auto& f) { return std::tie(f.radius); }  // int radius: the function takes an int
//
// A shadow's uniform block holds them as the components of one vec4, in their order.
#pragma once

#include <concepts>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace umbrage {
namespace detail {

/// Tuple of references to a filter's numbers.
template <class Filter>
using numbers_of = decltype(std::remove_cvref_t<Filter>::numbers(std::declval<Filter&>()));

}  // namespace detail

namespace glsl {

/// Name of a number's type in GLSL; empty for types that are none of a filter's numbers.
template <class Number>
inline constexpr std::string_view number_type{};
template <>
inline constexpr std::string_view number_type<int> = "int";
template <>
inline constexpr std::string_view number_type<float> = "float";
template <>
inline constexpr std::string_view number_type<glm::vec2> = "vec2";
template <>
inline constexpr std::string_view number_type<glm::vec3> = "vec3";
template <>
inline constexpr std::string_view number_type<glm::vec4> = "vec4";

}  // namespace glsl

namespace detail {

/// Number of floats of a filter's number in a uniform block.
template <class Number>
inline constexpr int width_of_number = static_cast<int>(sizeof(Number) / sizeof(float));

/// Calls use(number) for each of a filter's numbers, in their order.
template <class Filter>
constexpr void for_each_number(Filter& filter, const auto& use) {
    std::apply([&](auto&... all) { (use(all), ...); }, std::remove_cvref_t<Filter>::numbers(filter));
}

/// Sums of a tuple of references: whether GLSL has all types, and how many floats they are.
template <class Numbers>
struct number_list;
template <class... Numbers>
struct number_list<std::tuple<Numbers&...>> {
    static constexpr bool known = (!glsl::number_type<std::remove_const_t<Numbers>>.empty() && ...);
    static constexpr int width = (width_of_number<std::remove_const_t<Numbers>> + ... + 0);
};

/// Filter whose numbers are of types that GLSL has, four floats at most.
template <class Filter>
concept with_numbers = requires(const Filter& f) {
    Filter::numbers(f);
}
&&number_list<numbers_of<const Filter>>::known&& number_list<numbers_of<const Filter>>::width <= 4;

/// Number of floats that a filter's numbers take in a uniform block.
template <with_numbers Filter>
inline constexpr int width_of_numbers = number_list<numbers_of<const Filter>>::width;

/// A filter's numbers as a uniform block holds them.
template <with_numbers Filter>
[[nodiscard]] constexpr glm::vec4 packed_numbers(const Filter& filter) {
    glm::vec4 all(0.0f);
    glm::length_t at = 0;
    for_each_number(filter, [&]<class Number>(const Number& n) {
        constexpr int width = width_of_number<Number>;
        if constexpr (width == 1) all[at] = static_cast<float>(n);
        else {
            const glm::vec<width, float> v(n);
            for (glm::length_t i = 0; i < width; ++i) all[at + i] = v[i];
        }
        at += width;
    });
    return all;
}

/// The filter with numbers as a uniform block holds them.
template <with_numbers Filter>
[[nodiscard]] constexpr Filter with_packed_numbers(Filter filter, const glm::vec4& all) {
    glm::length_t at = 0;
    for_each_number(filter, [&]<class Number>(Number& n) {
        constexpr int width = width_of_number<Number>;
        if constexpr (width == 1) n = static_cast<Number>(all[at]);
        else if constexpr (width == 2) n = Number{all[at], all[at + 1]};
        else if constexpr (width == 3) n = Number{all[at], all[at + 1], all[at + 2]};
        else n = Number{all.x, all.y, all.z, all.w};
        at += width;
    });
    return filter;
}

}  // namespace detail
}  // namespace umbrage
