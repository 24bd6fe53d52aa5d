// SPDX-License-Identifier: MIT
//
// Depth as color, so that people can see it: blue near, through cyan, green and yellow, to red far.
//
//     glm::vec3 color = umbrage::false_color(depth);
//
#pragma once

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// @param v       clamped to [0, 1]; NaN counts as far
/// @return        RGB in [0, 1]; brightness ramps up at both ends: 0 is dark blue, 1 dark red
/// @formula       3/2 - |4 v - c|, clamped, with c = 3, 2, 1 for red, green, blue
/// @exactness     B, n = 3: one rounded difference a channel
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> false_color(T v, T cleared = T(1)) {
    const T x = saturate(v, cleared) * T(4);
    const auto ramp = [x](T peak) {
        const T distance = x < peak ? peak - x : x - peak;
        return saturate(T(1.5) - distance);
    };
    return {ramp(T(3)), ramp(T(2)), ramp(T(1))};
}

namespace glsl {

inline constexpr snippet false_color{
    .name = "false_color",
    .summary = "0..1 to blue, green, red",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
UMBRAGE_HIGHP vec3 umbrage_false_color(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float x = umbrage_saturate(v) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 ramp = 1.5 - abs(vec3(x - 3.0, x - 2.0, x - 1.0));
    return vec3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
)GLSL",
};

inline constexpr const snippet* false_color_snippets[]{&false_color};

}  // namespace glsl
}  // namespace umbrage
