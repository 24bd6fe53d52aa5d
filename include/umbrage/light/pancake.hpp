// SPDX-License-Identifier: MIT
//
// Pancaking: the vertex shader clamps casters to the near plane, for rasterizers that cannot clamp depth.
//
//     gl_Position = umbrage_pancake(clip_from_world * position, 0.0);   // umbrage::near_depth(clip)
//
// Also called: shadow pancaking. Better where available: depth clamping by the rasterizer (GL_DEPTH_CLAMP).
#pragma once

#include <glm/vec4.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// z/w of the near plane: 0 or -1, and 1 for reversed depth.
/// @throws std::invalid_argument  clip unset
[[nodiscard]] constexpr float near_depth(clip_space clip) {
    detail::require_given(clip, "near_depth");
    if (clip.direction == depth_direction::reversed) return 1.0f;
    return clip.range == depth_range::zero_to_one ? 0.0f : -1.0f;
}

/// Position of a vertex, clamped along z to the near plane. For directional lights: w is 1, or a warp's.
///
/// It is correct for triangles wholly on one side of the plane. A triangle that crosses the plane is bent, and its part
/// behind the plane comes out too far from the light. Prefer a rasterizer that clamps.
/// @param position   position in clip space
/// @param at_near    z/w of the near plane, from near_depth: 0, -1, or 1, which means reversed depth
/// @return           position with z = max(z, at_near w), or min for reversed depth
/// @edge             NaN in z: unchanged
/// @exactness        B, n = 1, S = |at_near w|: it selects. If denormals compare as zero, they stay unclamped
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> pancake(glm::vec<4, T> position, T at_near) {
    const T plane = at_near * position.w;
    const bool before = at_near > T(0.5) ? position.z > plane : position.z < plane;
    return {position.x, position.y, before ? plane : position.z, position.w};
}

namespace glsl {

inline constexpr snippet pancake{
    .name = "pancake",
    .summary = "casters clamped to the near plane (pancaking)",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
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
