// SPDX-License-Identifier: MIT
//
// Whether a filter has to be asked at all: where all texels that it may touch are lit, or none is, one look-up into
// their bounds says so, and what it says are the filter's bits. In shaders, with bounds of make_filter_bounds as a map:
//
//     float lit = umbrage_bounds_lit_sun_bounds(bounds, bounds_size, coord, receiver, place);
//     if (lit < 0.0) lit = umbrage_binomial7_sun(map, size, coord, receiver);
//
// Pays off for filters of many texels, and where shadows have more inside than border.
#pragma once

#include <umbrage/core/texel_space.hpp>

namespace umbrage {

/// What every filter of a reach gives where bounds suffice.
/// @param bounds     ivec2 -> vec2, least and greatest depth of the texels that it may touch; the least is a NaN where
///                   one of them is
/// @param coord      receiver in texels of the map, as the filter takes it
/// @param receiver   depth, as the filter takes it
/// @param place      which bounds are a receiver's, see make_filter_bounds
/// @return           1 where all are lit, 0 where none is, else -1: ask the filter
/// @formula          [receiver <= least] where that is [receiver <= greatest], else -1; both of the bounds
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
    .summary = "visibility where bounds of a filter's texels suffice",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &compare, &fetch_clamped>,
    .source = R"GLSL(
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
UMBRAGE_HIGHP float umbrage_bounds_lit(UMBRAGE_MAP bounds, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    UMBRAGE_HIGHP float all = umbrage_compare(receiver, b.x);
    UMBRAGE_HIGHP float some = umbrage_compare(receiver, b.y);
    UMBRAGE_HIGHP float known = b.x <= b.y && all == some ? all : -1.0;  // not of a NaN
    return compared ? known : 1.0;
}
)GLSL",
};

inline constexpr const snippet* bounds_lit_snippets[]{&bounds_lit};

}  // namespace glsl
}  // namespace umbrage
