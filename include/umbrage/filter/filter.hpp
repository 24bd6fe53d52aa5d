// SPDX-License-Identifier: MIT
//
// Concepts of a shadow filter: a callable that computes visibility from a map's texels.
//
//     umbrage::filters::box filter{.radius = 2, .direction = light.clip.direction};
//     float visibility = filter(umbrage::bordered(map), coord, depth - bias);
//
// Functions over images take any such callable. They set its direction to that of the map's encoding.
// Set it yourself only when you call the filter with your own fetch, as above.
// See also: filters.hpp, the list of this library's filters.
#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/filter/numbers.hpp>

namespace umbrage {
namespace detail {

/// Stand-in for a map's fetch, with which the concepts below try a filter.
struct any_fetch {
    float operator()(glm::ivec2 texel) const;
};

/// Vector that GLM would shorten to a glm::vec2 without a warning. Filters delete the call that takes it.
template <class Coord>
concept longer_than_vec2 = requires(Coord coord) {
    coord.z;
};

}  // namespace detail

/// Callable (fetch, coord, receiver) -> visibility. Functions over images need no more than this. If it has
/// check(std::string_view function), they call that once: it refuses numbers out of range, in the function's name.
template <class Filter>
concept filter = std::copy_constructible<Filter> &&
    requires(const Filter& f, const detail::any_fetch& fetch, float receiver) {
    { f(fetch, glm::vec2(), receiver) } -> std::convertible_to<float>;
};

/// Filter with a name, a snippet, its numbers, a reach and a direction of depth, as all of this library's filters have.
template <class Filter>
concept known_filter = filter<Filter> && requires(const Filter& f) {
    { f.name } -> std::convertible_to<std::string_view>;         // a C++ identifier
    { f.snippet } -> std::convertible_to<const glsl::snippet*>;  // C++ version and snippet return the same result
    {Filter::numbers(f)};                                        // those that its snippet takes: numbers.hpp
    { f.reach() } -> std::same_as<float>;  // filter radius: distance to the farthest texel center, along an axis
    { f.direction } -> std::convertible_to<depth_direction>;
};

namespace detail {

/// Checks that a type can be used as a filter, with a readable error message.
template <class Filter>
consteval bool is_filter() {
    static_assert(filter<Filter>,
                  "an umbrage filter is a callable (fetch, glm::vec2 coord, float receiver) -> float, const");
    return true;
}

/// Calls a filter's check, if it has one. Functions call it once before many lookups.
template <class Filter>
void require_filter(std::string_view function, const Filter& filter) {
    if constexpr (requires { filter.check(function); }) filter.check(function);
}

/// Refuses a border that a filter reads beyond. Where maps meet, shadows would end in a line.
/// @param border   texels around the part of a map that holds receivers
/// @param reach    the filter's, texels. A border of the reach is enough, as texels whose centers are farther away do
///                 not count
inline void require_reach(std::string_view function, std::string_view argument, int border, float reach) {
    require(static_cast<float>(border) >= reach, function, argument, printed(std::ceil(reach)) + " or more", border,
            "The filter reaches " + printed(reach) + " texels to each side.");
}

}  // namespace detail
}  // namespace umbrage
