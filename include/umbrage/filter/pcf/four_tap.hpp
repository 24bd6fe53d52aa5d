// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering (PCF) over four taps with separate coordinates, as on the Radeon 8500. There, each tap
// had its own texture matrix (`tap_matrices`), a nearest fetch and a test. The result was the mean of the tests.
//
//     float visibility = umbrage::four_tap(umbrage::bordered(map), a, b, c, d, depth - bias);
//
// See also: pcf_2x2.hpp, with bilinear weights; four_tap_hardware.hpp.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include <umbrage/core/texel_space.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// Mean of four shadow tests, each with its own coordinates.
/// @param fetch        returns the stored depth of a texel: float(glm::ivec2). Called up to 4 times
/// @param a            position of the first tap in the map, in texels
/// @param b            position of the second tap
/// @param c            position of the third tap
/// @param d            position of the fourth tap
/// @param receiver     receiver depth in [0, 1], with the bias already applied
/// @param is_lit       less_equal, or greater_equal for reversed depth
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @edge               taps whose mean |texel index| is 2^15 or more along an axis, or NaN: 1. Receiver beyond the far
///                     plane: 1. NaN receiver: 0
/// @formula            mean of [receiver <= fetch(floor(tap))]
/// @exactness          A
/// @cite               Reeves, Salesin, Cook 1987; ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap(Fetch&& fetch, glm::vec<2, T> a, glm::vec<2, T> b, glm::vec<2, T> c, glm::vec<2, T> d,
                         T receiver, Compare is_lit = {}) {
    const std::array<glm::vec<2, T>, 4> texels{glm::floor(a), glm::floor(b), glm::floor(c), glm::floor(d)};
    const glm::vec<2, T> sum = glm::abs(texels[0]) + glm::abs(texels[1]) + glm::abs(texels[2]) + glm::abs(texels[3]);
    const auto inside = [](T v) { return !is_nan(v) && v < T(1 << 17); };
    if (!inside(sum.x) || !inside(sum.y) || beyond_far_plane(receiver, is_lit)) return T(1);
    T count(0);
    for (const glm::vec<2, T>& texel : texels) count += lit(fetch, glm::ivec2(texel), receiver, is_lit);
    return count * T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap{
    .name = "four_tap",
    .summary = "mean of four taps, each with its own coordinates",
    .exactness = tier::a,
    .needs = list<&lit, &beyond_far_plane>,
    .source = R"GLSL(
// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_four_tap(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                     UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                     UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 a_texel = floor(a);
    UMBRAGE_HIGHP vec2 b_texel = floor(b);
    UMBRAGE_HIGHP vec2 c_texel = floor(c);
    UMBRAGE_HIGHP vec2 d_texel = floor(d);
    UMBRAGE_HIGHP vec2 sum = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    UMBRAGE_HIGHP float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
                                umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// Four-tap filter as a value.
struct four_tap {
    static constexpr std::string_view name = "four_tap";
    static constexpr const glsl::snippet* snippet = &glsl::four_tap;

    std::array<glm::vec2, 4> offsets = default_taps<float>;  ///< from the receiver to each tap, in texels
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.offsets); }
    [[nodiscard]] constexpr float reach() const {
        float farthest = 0.0f;
        for (glm::vec2 offset : offsets)
            for (float along : {offset.x, -offset.x, offset.y, -offset.y})
                farthest = along > farthest ? along : farthest;
        return farthest + 0.5f;
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::four_tap(fetch, coord + offsets[0], coord + offsets[1], coord + offsets[2], coord + offsets[3],
                                 receiver, comparison{direction});
    }
    void operator()(auto&&, const detail::longer_than_vec2 auto&, auto&&...) const = delete;
};

}  // namespace filters
}  // namespace umbrage
