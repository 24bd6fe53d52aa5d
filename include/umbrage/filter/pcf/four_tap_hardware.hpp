// SPDX-License-Identifier: MIT
//
// four_tap by the sampler, as the Radeon 8500 had it: coordinates that four texture matrices give are the sampler's as
// they are, and its nearest texel is the tap's.
//
//     float visibility = umbrage::four_tap_hardware(umbrage::bordered(map), size, a, b, c, d, depth - bias);
//
// In a shader bind it to a map with `gather` set, which says that there is a sampler of the nearest texel. Taps within
// a rounding of a texel's border may read the texel beside it.
#pragma once

#include <umbrage/filter/pcf/four_tap.hpp>

namespace umbrage {

/// @param fetch        ivec2 texel -> stored depth; called four times
/// @param size         of the map, in texels
/// @param a, b, c, d   the taps, from (0, 0) to (1, 1) over the map; all are lit where the mean of |x| + |y| in texels
///                     is 2^15 or more, and for NaN
/// @param receiver     depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @formula            mean of [receiver <= depth_at(tap)]
/// @exactness          C, n = 39, four_tap but at borders between texels, as depth_at. S = uv size, or for what is out
///                     of range the sum of all |x| + |y| in texels
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
    .summary = "mean of four taps that a sampler of the nearest texel takes",
    .exactness = tier::c,
    .operations = 39,
    .needs = list<&beyond_far_plane, &compare, &depth_at>,
    .source = R"GLSL(
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
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
