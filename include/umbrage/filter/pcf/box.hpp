// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) with a (2r+1) x (2r+1) box of equal weights.
//
//     float visibility = umbrage::box(umbrage::bordered(map), coord, depth - bias, 2);  // 5 x 5
//
// Also called: NxN PCF, box PCF, 5x5 PCF. See also: windows.hpp for smooth edges, disc.hpp for wide filters.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <tuple>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// Largest radius of a box, in texels.
inline constexpr int max_box_radius = 8;

/// Number of lit texels in the box around the receiver's texel.
///
/// @param fetch      returns the stored depth of a texel: float(glm::ivec2). Called (2r+1)^2 times, with indices up to
///                   r texels outside the map: pass clamped(map) or bordered(map)
/// @param coord      receiver position in the map, in texels: (0.5, 0.5) is the center of the first texel
/// @param receiver   receiver depth in [0, 1], with the bias already applied
/// @param radius     r, in texels; clamped to 0..8
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           number of lit texels, 0 to (2r+1)^2
///
/// @edge             coord outside texel space or NaN: all lit. Receiver beyond the far plane: all lit. NaN receiver: 0
/// @formula          sum over |i|, |j| <= r of [receiver <= fetch(floor(coord) + (i, j))]
/// @exactness        A: counts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T box_count(Fetch&& fetch, glm::vec<2, T> coord, T receiver, int radius, Compare is_lit = {}) {
    const int r = radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius);
    if (!in_filter_domain(coord, receiver, is_lit)) return T((2 * r + 1) * (2 * r + 1));
    const glm::ivec2 texel(glm::floor(coord));
    int count = 0;
    for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) count += is_lit(receiver, T(fetch(texel + glm::ivec2(i, j)))) ? 1 : 0;
    return T(count);
}

namespace detail {
template <real T>  // the compiler divides: at run time, the rounding mode and -ffast-math could change the quotients
inline constexpr std::array<T, max_box_radius + 1> box_scales{T(1),          T(1) / T(9),   T(1) / T(25),
                                                              T(1) / T(49),  T(1) / T(81),  T(1) / T(121),
                                                              T(1) / T(169), T(1) / T(225), T(1) / T(289)};
}  // namespace detail

/// 1 / (2r+1)^2, rounded to nearest.
/// @param radius     r, in texels; clamped to 0..8
/// @exactness        A: a table
template <real T>
[[nodiscard]] constexpr T box_scale(int radius) {
    const int r = radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius);
    return detail::box_scales<T>[static_cast<std::size_t>(r)];
}

/// Fraction of the box that is lit. Parameters and edge cases as for box_count.
/// @return           visibility in [0, 1]: exactly 0 in shadow, exactly 1 lit
/// @formula          box_count / (2r+1)^2
/// @exactness        B, n = 290, S = the result: the count is exact, its product with box_scale rounds once
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T box(Fetch&& fetch, glm::vec<2, T> coord, T receiver, int radius, Compare is_lit = {}) {
    const T visibility = box_count(fetch, coord, receiver, radius, is_lit) * box_scale<T>(radius);
    return visibility < T(0.999) ? visibility : T(1);  // 121 times the rounded 1/121 is not 1
}

namespace glsl {

inline constexpr snippet box_count{
    .name = "box_count",
    .summary = "number of lit texels in a box of radius 0..8",
    .exactness = tier::a,
    .needs = list<&in_filter_domain, &lit>,
    .source = R"GLSL(
// umbrage_box_count: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
UMBRAGE_HIGHP float umbrage_box_count(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 first = compared ? floor(coord) - float(r) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + vec2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
)GLSL",
};

inline constexpr snippet box_scale{
    .name = "box_scale",
    .summary = "1 / (2r+1)^2",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
UMBRAGE_HIGHP float umbrage_box_scale(int radius) {
    UMBRAGE_HIGHP float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
)GLSL",
};

inline constexpr snippet box{
    .name = "box",
    .summary = "lit fraction of a box of radius 0..8 (box PCF)",
    .exactness = tier::b,
    .operations = 290,
    .needs = list<&box_count, &box_scale>,
    .source = R"GLSL(
// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
UMBRAGE_HIGHP float umbrage_box(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, int radius) {
    UMBRAGE_HIGHP float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// Box filter as a value.
struct box {
    static constexpr std::string_view name = "box";
    static constexpr const glsl::snippet* snippet = &glsl::box;

    int radius = 1;  ///< in texels; clamped to 0..8
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.radius); }
    [[nodiscard]] constexpr float reach() const {
        return static_cast<float>(radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius)) + 0.5f;
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

}  // namespace filters
}  // namespace umbrage
