// SPDX-License-Identifier: MIT
//
// Conventions as values: which way the camera looks, what depth means, where the first texel is.
// Passed explicitly everywhere; GLM's configuration macros are neither read nor needed.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .clip = umbrage::vulkan_clip_space});
//
#pragma once

#include <umbrage/shader/snippet.hpp>

namespace umbrage {

/// Of the world and of view space alike, as in lookAtRH and lookAtLH: the view is a rotation, never a mirror.
/// Seen from the light, x is to the right and y up; right looks down -z, left down +z. A mesh keeps its winding: what
/// goes clockwise for the light goes clockwise in NDC, y up.
enum class handedness { right, left };
enum class depth_range { zero_to_one, minus_one_to_one };  ///< of z/w between the planes
enum class depth_direction { forward, reversed };          ///< reversed: the near plane has the greater depth
enum class texture_origin { bottom, top };                 ///< where texel (0, 0) is: at NDC y = -1, or y = +1

struct clip_space {
    handedness hand = handedness::right;
    depth_range range = depth_range::zero_to_one;
    depth_direction direction = depth_direction::forward;
    texture_origin origin = texture_origin::bottom;

    friend constexpr bool operator==(const clip_space&, const clip_space&) = default;
};

/// Right-handed world, z/w in [-1, 1], texels from the bottom. With glClipControl: vulkan_clip_space.
inline constexpr clip_space opengl_clip_space{.range = depth_range::minus_one_to_one};

/// Right-handed world, z/w in [0, 1]; the first texel is at NDC y = -1, which Vulkan draws at the top.
inline constexpr clip_space vulkan_clip_space{};

/// Left-handed world, as D3DXMatrixLookAtLH has it, z/w in [0, 1], texels from the top.
inline constexpr clip_space direct3d_clip_space{.hand = handedness::left, .origin = texture_origin::top};

/// Right-handed world, z/w in [0, 1], texels from the top: WebGPU as three.js and glTF viewers use it, and right-handed
/// worlds under Direct3D. WebGPU and Metal have no hand of their own: for a left-handed world take direct3d_clip_space.
inline constexpr clip_space webgpu_clip_space{.origin = texture_origin::top};
inline constexpr clip_space metal_clip_space = webgpu_clip_space;

/// The depth of the far plane, to which a map is cleared.
[[nodiscard]] constexpr float cleared_depth(depth_direction direction) {
    return direction == depth_direction::forward ? 1.0f : 0.0f;
}
[[nodiscard]] constexpr float cleared_depth(clip_space clip) { return cleared_depth(clip.direction); }

namespace glsl {

inline constexpr snippet cleared_depth{
    .name = "cleared_depth",
    .summary = "depth of the far plane",
    .exactness = tier::a,
    .role = hook::cleared_depth,
    .source = R"GLSL(
// umbrage_cleared_depth: depth of the far plane, 1.0; after #define UMBRAGE_REVERSED 0.0
UMBRAGE_HIGHP float umbrage_cleared_depth() {
#ifdef UMBRAGE_REVERSED
    return 0.0;
#else
    return 1.0;
#endif
}
)GLSL",
};

inline constexpr const snippet* clip_space_snippets[]{&cleared_depth};

}  // namespace glsl
}  // namespace umbrage
