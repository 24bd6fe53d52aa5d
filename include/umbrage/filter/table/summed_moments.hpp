// SPDX-License-Identifier: MIT
//
// Moment shadows (MSM) from a summed-area table (SAT): a box filter of any size from its four corners.
//
//     umbrage::image<glm::u16vec4> table = umbrage::make_moment_table(map, {.radius = 16});
//     float visibility = umbrage::summed_moments(umbrage::clamped(table), table.size(), coord, depth - bias, 16.0f,
//                                                umbrage::msm_bias_16);
//
// The table holds optimized moments as integers of 16 bits, so their sums over a box are exact. Its left half stores
// the sums modulo 2^16. Its right half stores the sums divided by 2^16. One RGBA16UI texture holds both.
// Also called: summed-area moment shadow maps. See also: summed_variance.hpp, which needs less memory.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/prefiltered/msm.hpp>

namespace umbrage {

/// Mean over a box of four integers below 2^16, from a summed-area table.
/// @param table        returns a texel of the table: four integers below 2^16, from glm::ivec2. The left half holds
///                     sums over all texels before a column and a row, modulo 2^16. The right half holds the same sums
///                     over 2^16, modulo 2^16
/// @param half_width   columns of each half
/// @param first        lowest column and row of the box
/// @param end          highest column and row of the box plus one; first < end
/// @formula            (a - b - c + d) mod 2^32 over the number of texels
/// @exactness          C, n = 19: a division. S is below 2^36 (first + end).x (first + end).y / texels^2. The dividend
///                     is the sum to half an ulp while the sum is below 2^32, however often the table wrapped
template <real T, class Fetch>
[[nodiscard]] glm::vec<4, T> box_mean(Fetch&& table, int half_width, glm::ivec2 first, glm::ivec2 end) {
    const auto part = [&](int right) {
        const glm::ivec2 half(right, 0);
        const glm::vec<4, T> a(table(half + end)), b(table(half + glm::ivec2(first.x, end.y)));
        const glm::vec<4, T> c(table(half + glm::ivec2(end.x, first.y))), d(table(half + first));
        return (a - b) - (c - d);
    };
    const glm::vec<4, T> low = part(0), carry = glm::floor(low * T(1.0 / 65536.0)), above = part(half_width) + carry;
    const glm::vec<4, T> high = above - glm::floor(above * T(1.0 / 65536.0)) * T(65536);
    const glm::vec<2, T> sides(end - first);
    return (high * T(65536) + (low - carry * T(65536))) / (sides.x * sides.y);
}

/// Upper bound on the lit fraction of a box, from the four moments of its depths.
/// @param table      returns a texel of the table, from make_moment_table
/// @param size       size of the table in texels: (2 (w + 1), h + 1) for a map of w x h
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     in texels, an integer >= 0, at most the table's radius. The box has 2 radius + 1 texels per side
/// @param bias       msm_bias_16
/// @param cleared    cleared depth: 1, or 0 where depth is reversed
/// @param outside    bordered: everything outside the map is lit. clamped: as at the map's edge. Only the texels of the
///                   box that lie inside the map count
/// @return           visibility: at least the lit fraction of the box, minus bias.x and decode_msm's error
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0. Radius
///                   below 0 or NaN: 0; above 32767: 32767
/// @formula          decode_msm of box_mean / 65535, through from_optimized_moments
/// @exactness        C, within 1/64 as written
/// @cite             Peters, Klein: Moment shadow mapping, I3D 2015; Crow: Summed-area tables for texture mapping,
///                   SIGGRAPH 1984
template <real T, class Fetch>
[[nodiscard]] T summed_moments(Fetch&& table, glm::ivec2 size, glm::vec<2, T> coord, T receiver, T radius,
                               glm::vec<2, T> bias, T cleared = T(1), outside_map outside = outside_map::bordered) {
    const comparison is_lit{cleared < T(0.5) ? depth_direction::reversed : depth_direction::forward};
    const glm::ivec2 map(size.x / 2 - 1, size.y - 1);
    if (!in_filter_domain(coord, receiver, is_lit) || !map_covers(glm::vec<2, T>(map), coord, outside)) return T(1);
    const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(coord)), glm::ivec2(0), map - 1);
    const int reach = is_nan(radius) ? 0 : static_cast<int>((glm::clamp)(radius, T(0), T(32767)));
    const glm::ivec2 first = (glm::max)(texel - reach, glm::ivec2(0)), end = (glm::min)(texel + reach + 1, map);
    const glm::vec<4, T> turned = box_mean<T>(table, size.x / 2, first, end) * T(1.0 / 65535.0);
    return decode_msm(from_optimized_moments(turned), receiver, bias, cleared);
}

namespace glsl {

inline constexpr snippet box_mean{
    .name = "box_mean",
    .summary = "mean of four integers over a box, from a SAT in two halves",
    .exactness = tier::c,
    .operations = 19,
    .needs = list<&texel>,
    .source = R"GLSL(
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
UMBRAGE_HIGHP vec4 umbrage_box_mean(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                    UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP float right = size.x * 0.5;
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 low = (a - b) - (c - d);
    UMBRAGE_HIGHP vec4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2(right + first.x, first.y));
    UMBRAGE_HIGHP vec4 above = (a - b) - (c - d) + carry;
    UMBRAGE_HIGHP vec4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = high * 65536.0 + (low - carry * 65536.0);
    UMBRAGE_HIGHP vec2 sides = end - first;
    return sum / (sides.x * sides.y);
}
)GLSL",
};

inline constexpr snippet summed_moments{
    .name = "summed_moments",
    .summary = "moment shadow over a box of any size, from a SAT",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&in_filter_domain, &map_covers, &box_mean, &from_optimized_moments, &decode_msm>,
    .source = R"GLSL(
// umbrage_summed_moments: moment shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_moment_table and its size: twice the shadow map's width plus two, its height plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   bias        (6e-5, 0.628)
UMBRAGE_HIGHP float umbrage_summed_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                           UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP vec2 last = vec2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr const snippet* summed_moments_snippets[]{&box_mean, &summed_moments};

}  // namespace glsl
}  // namespace umbrage
