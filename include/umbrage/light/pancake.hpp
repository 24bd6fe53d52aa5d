// SPDX-License-Identifier: MIT
//
// Casters before the near plane, pressed onto it by the vertex shader where the rasterizer cannot clamp depth.
//
//     gl_Position = umbrage_pancake(clip_from_world * position, 0.0);   // umbrage::near_depth(clip)
//
#pragma once

#include <glm/vec4.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// z/w of the near plane: 0 or -1, and 1 where depth is reversed.
/// @throws std::invalid_argument  clip unset
[[nodiscard]] constexpr float near_depth(clip_space clip) {
    detail::require_given(clip, "near_depth");
    if (clip.direction == depth_direction::reversed) return 1.0f;
    return clip.range == depth_range::zero_to_one ? 0.0f : -1.0f;
}

/// A vertex before the near plane, moved onto it along z: for directional lights, where w is 1. Right for triangles
/// wholly before the plane or behind it. One that crosses it is bent, and its part behind comes out too far: prefer a
/// rasterizer that clamps.
/// @param position   in clip space
/// @param at_near    z/w of the near plane, near_depth: 0, -1 or 1, where 1 says that depth is reversed
/// @return           z = max(z, at_near w), or min for reversed depth; a NaN in z stays
/// @exactness        B, n = 1, S = |at_near w|: selects; where denormals compare as zeros, those before the plane stay
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> pancake(glm::vec<4, T> position, T at_near) {
    const T plane = at_near * position.w;
    const bool before = at_near > T(0.5) ? position.z > plane : position.z < plane;
    return {position.x, position.y, before ? plane : position.z, position.w};
}

namespace glsl {

inline constexpr snippet pancake{
    .name = "pancake",
    .summary = "casters before the near plane, onto it",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_pancake: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
UMBRAGE_HIGHP vec4 umbrage_pancake(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP float at_near) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return vec4(position.x, position.y, before ? plane : position.z, position.w);
}
)GLSL",
};

inline constexpr const snippet* pancake_snippets[]{&pancake};

}  // namespace glsl
}  // namespace umbrage
