// SPDX-License-Identifier: MIT
//
// Percentage-closer filtering over four taps with coordinates of their own, as the Radeon 8500 did it: one texture
// matrix per tap (tap_matrices), four nearest fetches, four tests, the mean.
//
//     float visibility = umbrage::four_tap(umbrage::clamped(map), a, b, c, d, depth - bias);
//
#pragma once

#include <array>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// @param fetch        ivec2 texel -> stored depth; called up to four times
/// @param a, b, c, d   the taps in texels; a tap outside texel space, or NaN, is lit
/// @param receiver     depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @formula            mean of hard() at the four taps
/// @exactness          A
/// @cite               Reeves, Salesin, Cook 1987; ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap(Fetch&& fetch, glm::vec<2, T> a, glm::vec<2, T> b, glm::vec<2, T> c, glm::vec<2, T> d,
                         T receiver, Compare is_lit = {}) {
    return (hard(fetch, a, receiver, is_lit) + hard(fetch, b, receiver, is_lit) + hard(fetch, c, receiver, is_lit) +
            hard(fetch, d, receiver, is_lit)) *
           T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap{
    .name = "four_tap",
    .summary = "mean of four taps with coordinates of their own",
    .exactness = tier::a,
    .needs = list<&hard>,
    .source = R"GLSL(
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                     UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                     UMBRAGE_HIGHP float receiver) {
    return (umbrage_hard(map, size, a, receiver) + umbrage_hard(map, size, b, receiver) +
            umbrage_hard(map, size, c, receiver) + umbrage_hard(map, size, d, receiver)) * 0.25;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct four_tap {
    static constexpr std::string_view name = "four_tap";
    static constexpr const glsl::snippet* snippet = &glsl::four_tap;

    std::array<glm::vec2, 4> offsets = default_taps<float>;  ///< in texels
    comparison is_lit{};

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
                                 receiver, is_lit);
    }
};

}  // namespace filters
}  // namespace umbrage
