// SPDX-License-Identifier: MIT
//
// False color for depth: blue near the light, through cyan, green and yellow, to red far away.
//
//     glm::vec3 color = umbrage::false_color(depth);
//
// Also called: heat map, jet color map.
#pragma once

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// False color of a depth.
/// @param v       depth, clamped to [0, 1]
/// @param cleared depth of the far plane: 1, or 0 for reversed depth
/// @return        RGB in [0, 1]. Brightness falls at both ends: 0 is dark blue, 1 is dark red
/// @edge          NaN: the color of cleared
/// @formula       3/2 - |4 v - c|, clamped, with c = 3, 2, 1 for red, green, blue
/// @exactness     B, n = 3: one rounded difference per channel
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
    .summary = "depth 0..1 as a color from blue over green to red",
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
