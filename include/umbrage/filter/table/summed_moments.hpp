// SPDX-License-Identifier: MIT
//
// Moment shadows from a summed-area table: a box of any size from its four corners.
//
//     umbrage::image<glm::u16vec4> table = umbrage::make_moment_table(map, {.radius = 16});
//     float visibility = umbrage::summed_moments(umbrage::clamped(table), table.size(), coord, depth - bias, 16.0f,
//                                                umbrage::msm_bias_16);
//
// The table holds turned moments as whole numbers of 16 bits, so that their sums over a box are exact: its left half
// has the sums modulo 2^16, its right half what they are over 2^16. That is one texture of RGBA16UI.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/lesser.hpp>
#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/prefiltered/msm.hpp>

namespace umbrage {

/// Mean of four whole numbers below 2^16 over a box.
/// @param table        ivec2 -> four whole numbers below 2^16: in the left half sums modulo 2^16 of all texels before
///                     a column and a row, in the right half the same sums over 2^16, modulo 2^16
/// @param half_width   columns of either half
/// @param first        of the box: lowest column and row;   end  highest and one, first < end
/// @formula            (a - b - c + d) mod 2^32 over the number of texels
/// @exactness          C, n = 19: a division. S is below 2^36 (first + end).x (first + end).y / texels^2, and the
///                     dividend is the sum to half an ulp, while that is below 2^32, however often the table wrapped
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

/// Share of the texels in a box that can be lit, from their four moments.
/// @param table      as make_moment_table makes it
/// @param size       of the table in texels: (2 (w + 1), h + 1) of a map of w x h
/// @param coord      receiver in texels of the map, the first texel's center is (0.5, 0.5); outside texel space, or
///                   NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     whole, >= 0: the box has 2 radius + 1 texels a side; at most the table's
/// @param bias       msm_bias_16
/// @param outside    bordered: outside the map all is lit; clamped: as at its edge. Of a box the texels inside count
/// @return           visibility: at least the lit share of the box, less bias.x and decode_msm's error
/// @formula          decode_msm of box_mean / 65535, turned back
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
    const int reach = static_cast<int>(radius);
    const glm::ivec2 first = detail::greater(texel - reach, glm::ivec2(0)),
                     end = detail::lesser(texel + reach + 1, map);
    const glm::vec<4, T> turned = box_mean<T>(table, size.x / 2, first, end) * T(1.0 / 65535.0);
    return decode_msm(from_optimized_moments(turned), receiver, bias, cleared);
}

namespace glsl {

inline constexpr snippet box_mean{
    .name = "box_mean",
    .summary = "mean of four whole numbers over a box, from a summed-area table in two halves",
    .exactness = tier::c,
    .operations = 19,
    .needs = list<&texel>,
    .source = R"GLSL(
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
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
    .summary = "moment shadow over a box of any size, from a summed-area table",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&in_filter_domain, &map_covers, &box_mean, &from_optimized_moments, &decode_msm>,
    .source = R"GLSL(
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
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
