// SPDX-License-Identifier: MIT
//
// Four-tap percentage-closer filtering (PCF) by the sampler, as on the Radeon 8500. Its coordinates come from four
// texture matrices, and it reads the nearest texel of each.
//
//     float visibility = umbrage::four_tap_hardware(umbrage::bordered(map), size, a, b, c, d, depth - bias);
//
// In a shader, bind it to a map with `gather` set: such a map has a sampler for the nearest texel. A tap that lies
// within a rounding error of a texel's border may read the next texel.
// See also: four_tap.hpp, exact on every GPU.
#pragma once

#include <umbrage/filter/pcf/four_tap.hpp>

namespace umbrage {

/// Mean of four shadow tests at coordinates from 0 to 1 over the map.
/// @param fetch        returns the stored depth of a texel: float(glm::ivec2). Called 4 times
/// @param size         size of the map, in texels
/// @param a            position of the first tap, from (0, 0) to (1, 1) over the map
/// @param b            position of the second tap
/// @param c            position of the third tap
/// @param d            position of the fourth tap
/// @param receiver     receiver depth in [0, 1], with the bias already applied
/// @param is_lit       less_equal, or greater_equal for reversed depth
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @edge               taps whose mean of |x| + |y| is 2^15 texels or more, or NaN: 1. Receiver beyond the far plane:
///                     1. NaN receiver: 0
/// @formula            mean of [receiver <= depth_at(tap)]
/// @exactness          C, n = 39, as four_tap except at borders between texels, as depth_at. S = uv size. For taps out
///                     of range, S is the sum of all |x| + |y| in texels
/// @cite               ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap_hardware(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> a, glm::vec<2, T> b,
                                  glm::vec<2, T> c, glm::vec<2, T> d, T receiver, Compare is_lit = {}) {
    const glm::vec<2, T> sum = (glm::abs(a) + glm::abs(b) + glm::abs(c) + glm::abs(d)) * size;
    const T reached = sum.x + sum.y;
    if (is_nan(reached) || reached >= T(1 << 17) || beyond_far_plane(receiver, is_lit)) return T(1);
    T count(0);
    for (const glm::vec<2, T>& uv : {a, b, c, d}) count += compare(receiver, depth_at(fetch, size, uv), is_lit);
    return count * T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap_hardware{
    .name = "four_tap_hardware",
    .summary = "mean of four taps from a nearest-texel sampler",
    .exactness = tier::c,
    .operations = 39,
    .needs = list<&beyond_far_plane, &compare, &depth_at>,
    .source = R"GLSL(
// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_four_tap_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                              UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                              UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    UMBRAGE_HIGHP float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
)GLSL",
};

inline constexpr const snippet* four_tap_hardware_snippets[]{&four_tap_hardware};

}  // namespace glsl
}  // namespace umbrage
