// SPDX-License-Identifier: MIT
//
// Early exit for a filter: one fetch from a map of depth bounds decides where all of its texels are lit, or none is.
// The result there has the filter's own bits. In shaders, bind the bounds of `make_filter_bounds` as a map:
//
//     float lit = umbrage_bounds_lit_sun_bounds(bounds, bounds_size, coord, receiver, place);
//     if (lit < 0.0) lit = umbrage_binomial7_sun(map, size, coord, receiver);
//
// It is worth the fetch for filters of many texels, and for shadows with more interior than border.
// Also called: early out, min-max shadow map, hierarchical shadow map. See also: images/filter_bounds.hpp.
#pragma once

#include <umbrage/core/texel_space.hpp>

namespace umbrage {

/// Early exit of a filter: 1 or 0 if the depth bounds already decide the result, otherwise -1.
/// @param bounds     returns the bounds at a texel: glm::vec2(glm::ivec2). They are the smallest and the largest depth
///                   of the texels that the filter may read. The smallest is NaN where one of those texels is NaN
/// @param coord      receiver in texels of the shadow map, as passed to the filter
/// @param receiver   receiver depth, as passed to the filter
/// @param place      maps a receiver to its bounds, from make_filter_bounds
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           1 where all texels are lit, 0 where none is, else -1: call the filter
/// @formula          [receiver <= smallest] where it equals [receiver <= largest], else -1; both read
///                   at floor((floor(256 coord) + place.x) place.y)
/// @exactness        A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T bounds_lit(Fetch&& bounds, glm::vec<2, T> coord, T receiver, glm::vec<2, T> place,
                           Compare is_lit = {}) {
    if (!in_filter_domain(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> b(bounds(glm::ivec2(glm::floor((glm::floor(coord * T(256)) + place.x) * place.y))));
    const T all = compare(receiver, b.x, is_lit), some = compare(receiver, b.y, is_lit);
    return all == some && !is_nan(b.x) && !is_nan(b.y) && b.x <= b.y ? all : T(-1);
}

namespace glsl {

inline constexpr snippet bounds_lit{
    .name = "bounds_lit",
    .summary = "visibility from depth bounds, an early exit of a filter",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &compare, &fetch_clamped>,
    .source = R"GLSL(
// umbrage_bounds_lit: early exit of a filter. Returns 1.0 where all texels are lit, 0.0 where none is
// Returns -1.0 where the bounds do not decide it: call the filter there
//   bounds, size      map of the texels' smallest and largest depths, and its size in texels
//   coord, receiver   as passed to the filter
//   place             maps a receiver to its bounds, from make_filter_bounds
UMBRAGE_HIGHP float umbrage_bounds_lit(UMBRAGE_MAP bounds, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    UMBRAGE_HIGHP float all = umbrage_compare(receiver, b.x);
    UMBRAGE_HIGHP float some = umbrage_compare(receiver, b.y);
    UMBRAGE_HIGHP float known = b.x <= b.y && all == some ? all : -1.0;  // NaN bounds decide nothing
    return compared ? known : 1.0;
}
)GLSL",
};

inline constexpr const snippet* bounds_lit_snippets[]{&bounds_lit};

}  // namespace glsl
}  // namespace umbrage
