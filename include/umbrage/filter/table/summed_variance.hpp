// SPDX-License-Identifier: MIT
//
// Variance shadows (VSM) from a summed-area table (SAT): a box filter of any size from four texels.
//
//     umbrage::image<glm::u16vec4> table = umbrage::make_variance_table(map, {.bits = 11, .radius = 16});
//     float visibility =
//         umbrage::summed_variance(umbrage::clamped(table), map.size(), coord, depth - bias, 16.0f, 2048.0f);
//
// The table's sums are integers modulo 2^32, and so are their differences. They are exact while the sum over a box is
// below 2^32. Squares are taken about the box's mean, rounded down, and stay integers. So nothing cancels but exact
// values, unlike n S2 - S1^2 in floats.
// Also called: SAVSM, SATVSM, summed-area variance shadow maps.
// See also: summed_moments.hpp, which has less light bleeding.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/floor_divide.hpp>
#include <umbrage/core/texel_space.hpp>

namespace umbrage {

/// Sums over a box of n texels, from a summed-area table of quantized depths (codes).
/// @param table   returns a texel of the table: four integers below 2^16, from glm::ivec2. They are the sums of codes,
///                modulo 2^16 and over 2^16, and the same of their squares. Sums are over all texels before a column
///                and row
/// @param first   lowest column and row of the box
/// @param end     highest column and row of the box plus one; first < end
/// @return        (mean, rest, high, low). The sum of the codes is n mean + rest, rest < n. The sum of their squared
///                distances from mean is 4096 high + low, low < 4096
/// @formula       with T = sum + rest: squares - mean T, in digits of 12 bits
/// @exactness     A while codes are below 2^12, n times the number of codes is at most 2^24 and the sum of squared
///                distances < 2^32. make_variance_table ensures that, however often the table has wrapped
template <real T, class Fetch>
[[nodiscard]] glm::vec<4, T> box_moments(Fetch&& table, glm::ivec2 first, glm::ivec2 end) {
    using four = glm::vec<4, T>;
    const four a(table(end)), b(table(glm::ivec2(first.x, end.y)));
    const four c(table(glm::ivec2(end.x, first.y))), d(table(first));
    const four part = (a - b) - (c - d);
    const T carry_1 = glm::floor(part.x * T(1.0 / 65536.0)), carry_2 = glm::floor(part.z * T(1.0 / 65536.0));
    const T above_1 = part.y + carry_1, above_2 = part.w + carry_2;
    // Nothing below is negative. The maxima keep compilers from regrouping sums across them.
    const T low_1 = (glm::max)(part.x - carry_1 * T(65536), T(0)),
            low_2 = (glm::max)(part.z - carry_2 * T(65536), T(0));
    const T high_1 = (glm::max)(above_1 - glm::floor(above_1 * T(1.0 / 65536.0)) * T(65536), T(0));
    const T sum = high_1 * T(65536) + low_1;
    const T high_2 = above_2 - glm::floor(above_2 * T(1.0 / 65536.0)) * T(65536);
    const glm::vec<2, T> sides(end - first);
    const T n = sides.x * sides.y, mean = floor_divide(sum, n), rest = sum - mean * n, factor = sum + rest;
    const T factor_high = glm::floor(factor * T(1.0 / 4096.0)), factor_low = factor - factor_high * T(4096);
    const T square_high = glm::floor(low_2 * T(1.0 / 4096.0)), square_low = low_2 - square_high * T(4096);
    const T below = square_low - mean * factor_low, borrow = glm::floor(below * T(1.0 / 4096.0));
    const T wide = high_2 * T(16) + square_high - mean * factor_high + borrow;
    const T high = wide - glm::floor(wide * T(1.0 / 1048576.0)) * T(1048576);
    return {mean, rest, high, below - borrow * T(4096)};
}

/// Upper bound on the lit fraction of a box: Chebyshev's inequality, from its mean and variance.
/// @param table      returns a texel of the table, from make_variance_table
/// @param size       size of the map in texels; the table has one more column and row
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     in texels, an integer >= 0, at most the table's radius. The box has 2 radius + 1 texels per side
/// @param codes      2^bits of the table
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @param outside    bordered: everything outside the map is lit. clamped: as at the map's edge. Only the texels of the
///                   box that lie inside the map count
/// @return           visibility: 1 where the receiver is no farther than the mean, else an upper bound on the lit
///                   fraction
/// @edge             coord outside texel space or NaN: 1. Receiver beyond the far plane: 1. NaN receiver: 0. Radius
///                   below 0 or NaN: 0; above 32767: 32767
/// @formula          m, v mean and variance of the codes + 1: d = codes receiver - m; d <= 0 ? 1 : v / (v + d^2)
/// @exactness        C, within 1/65536: two divisions, on numbers that do not cancel; d is off by 2^-23 where v is at
///                   least 1/64^2
/// @cite             Lauritzen: Summed-area variance shadow maps, GPU Gems 3, 2007; Donnelly, Lauritzen: Variance
///                   shadow maps, I3D 2006
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T summed_variance(Fetch&& table, glm::ivec2 size, glm::vec<2, T> coord, T receiver, T radius, T codes,
                                Compare is_lit = {}, outside_map outside = outside_map::bordered) {
    if (!in_filter_domain(coord, receiver, is_lit) || !map_covers(glm::vec<2, T>(size), coord, outside)) return T(1);
    const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(coord)), glm::ivec2(0), size - 1);
    const int reach = is_nan(radius) ? 0 : static_cast<int>((glm::clamp)(radius, T(0), T(32767)));
    const glm::ivec2 first = (glm::max)(texel - reach, glm::ivec2(0)), end = (glm::min)(texel + reach + 1, size);
    const glm::vec<4, T> m = box_moments<T>(table, first, end);
    const T n = T((end.x - first.x) * (end.y - first.y)), share = m.y / n;
    const T variance = (m.z * T(4096) + (m.w - m.y)) / n + share * (T(1) - share);
    const T scaled = receiver * codes, t = is_lit(T(0), T(1)) ? scaled : codes - scaled;
    const T d = (t - T(1) - m.x) - share;
    if (is_nan(d)) return T(0);
    return d <= T(0) ? T(1) : variance / (variance + d * d);
}

namespace glsl {
inline constexpr snippet box_moments{
    .name = "box_moments",
    .summary = "mean and squared distances over a box, from a SAT",
    .exactness = tier::a,
    .needs = list<&texel, &floor_divide>,
    .source = R"GLSL(
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
UMBRAGE_HIGHP vec4 umbrage_box_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                       UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 part = (a - b) - (c - d);
    UMBRAGE_HIGHP vec2 low = vec2(part.x, part.z);
    UMBRAGE_HIGHP vec2 carry = floor(low * (1.0 / 65536.0));
    UMBRAGE_HIGHP vec2 above = vec2(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = max(low - carry * 65536.0, vec2(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float sum = above.x * 65536.0 + low.x;
    UMBRAGE_HIGHP vec2 sides = max(end - first, vec2(1.0, 1.0));
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(sum, n);
    UMBRAGE_HIGHP float rest = max(sum - mean * n, 0.0);
    UMBRAGE_HIGHP vec2 digits = vec2(sum + rest, low.y);
    UMBRAGE_HIGHP vec2 high = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float below = digits.y - mean * digits.x;
    UMBRAGE_HIGHP float borrow = floor(below * (1.0 / 4096.0));
    UMBRAGE_HIGHP float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4(mean, rest, wide, below - borrow * 4096.0);
}
)GLSL",
};

inline constexpr snippet summed_variance{
    .name = "summed_variance",
    .summary = "variance shadow over a box of any size, from a SAT",
    .exactness = tier::c,
    .within = 1.0f / 65536.0f,
    .needs = list<&in_filter_domain, &map_covers, &cleared_depth, &box_moments>,
    .source = R"GLSL(
// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
UMBRAGE_HIGHP float umbrage_summed_variance(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP float codes) {
    UMBRAGE_HIGHP vec2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 m = umbrage_box_moments(map, size, first, end);
    UMBRAGE_HIGHP vec2 sides = end - first;
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float share = m.y / n;
    UMBRAGE_HIGHP float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    UMBRAGE_HIGHP float scaled = receiver * codes;
    UMBRAGE_HIGHP float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    UMBRAGE_HIGHP float d = (t - 1.0 - m.x) - share;
    UMBRAGE_HIGHP float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
)GLSL",
};

inline constexpr const snippet* summed_variance_snippets[]{&box_moments, &summed_variance};

}  // namespace glsl
}  // namespace umbrage
