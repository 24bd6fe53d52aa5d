// SPDX-License-Identifier: MIT
//
// What a filter is: a value that makes visibility of a map's texels, and knows what there is to know of itself.
//
//     umbrage::filters::box filter{.radius = 2, .is_lit = {light.clip.direction}};
//     float visibility = filter(umbrage::bordered(map), coord, depth - bias);
//
// The library's own are listed in filters.hpp. Functions over images take any callable like them, and give its is_lit
// the direction of the map's encoding: only with a fetch of your own, as above, does the filter have to be told.
#pragma once

#include <concepts>
#include <string_view>

#include <glm/vec2.hpp>

#include <umbrage/core/snippet.hpp>

namespace umbrage {
namespace detail {

/// A map as filters see it.
struct any_fetch {
    float operator()(glm::ivec2 texel) const;
};

/// A vector that GLM would cut down to a glm::vec2 without a warning: filters delete the call that takes it.
template <class Coord>
concept longer_than_vec2 = requires(Coord coord) {
    coord.z;
};

}  // namespace detail

/// A callable (fetch, coord, receiver) -> visibility: all that functions over images ask for.
template <class Filter>
concept filter = std::copy_constructible<Filter> &&
    requires(const Filter& f, const detail::any_fetch& fetch, float receiver) {
    { f(fetch, glm::vec2(), receiver) } -> std::convertible_to<float>;
};

/// What a filter of the library tells of itself, for tools, tables and biases.
template <class Filter>
concept known_filter = filter<Filter> && requires(const Filter& f, float depth) {
    { f.name } -> std::convertible_to<std::string_view>;         // a C++ identifier
    { f.snippet } -> std::convertible_to<const glsl::snippet*>;  // of the same result
    { f.reach() } -> std::same_as<float>;  // from a receiver to the farthest center of a texel it reads, along an axis
    { f.is_lit(depth, depth) } -> std::same_as<bool>;  // the comparison, its direction inside
};

namespace detail {

/// Says in words what a type lacks that is used as a filter.
template <class Filter>
consteval bool is_filter() {
    static_assert(filter<Filter>,
                  "an umbrage filter is a callable (fetch, glm::vec2 coord, float receiver) -> float, const");
    return true;
}

}  // namespace detail
}  // namespace umbrage
