// SPDX-License-Identifier: MIT
//
// Clip space conventions as values: handedness, depth range, depth direction and the place of the first texel.
// Functions take them as an argument. They neither read nor need GLM's configuration macros.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .clip = umbrage::vulkan_clip_space});
//
// Also called: reversed Z, reverse-Z, inverted depth (depth_direction); glClipControl, zero-to-one depth, y flip
// (clip_space).
//
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Handedness of the world and of view space, as in lookAtRH and lookAtLH. The view is a rotation, never a mirror.
/// Seen from the light, x points right and y up. `right` looks down -z, `left` looks down +z.
/// A mesh keeps its winding: a triangle that is clockwise for the light is clockwise in NDC with y up.
enum class handedness { right, left };

/// Range of z/w from the near to the far plane.
enum class depth_range { unset, zero_to_one, minus_one_to_one };

/// Direction in which depth grows. `reversed`: it is larger at the near plane.
enum class depth_direction { forward, reversed };

/// Place of texel (0, 0): at NDC y = -1 (`bottom`), or at y = +1 (`top`).
enum class texture_origin { bottom, top };

/// Value of texels outside the map.
enum class outside_map {
    bordered,  ///< depth of the far plane, as with a border sampler: lit outside the map. The default, except for tiles
    clamped,   ///< the nearest texel inside: for tiles with a gutter, and for cube faces
};

/// Clip space that the map is drawn with. A wrong one makes everything lit, so functions refuse an unset range.
struct clip_space {
    handedness hand = handedness::right;
    depth_range range = depth_range::unset;
    depth_direction direction = depth_direction::forward;
    texture_origin origin = texture_origin::bottom;
    /// Bits of the grid within a texel to which the rasterizer moves vertices, which a shadow's bias covers: 4 is what
    /// OpenGL, OpenGL ES and Vulkan promise, 8 what Direct3D has. Ask yours for SUBPIXEL_BITS or subPixelPrecisionBits;
    /// with 8 in place of 4 each bias is 15/128 texel of slope smaller.
    int subpixel_bits = 4;

    friend constexpr bool operator==(const clip_space&, const clip_space&) = default;
};

/// Right-handed world with z/w in [-1, 1] and the first texel at the bottom. With glClipControl use vulkan_clip_space.
inline constexpr clip_space opengl_clip_space{.range = depth_range::minus_one_to_one};

/// Right-handed world with z/w in [0, 1]. The first texel is at NDC y = -1, which Vulkan draws at the top.
inline constexpr clip_space vulkan_clip_space{.range = depth_range::zero_to_one};

/// Left-handed world as in D3DXMatrixLookAtLH, with z/w in [0, 1] and the first texel at the top.
inline constexpr clip_space direct3d_clip_space{
    .hand = handedness::left, .range = depth_range::zero_to_one, .origin = texture_origin::top, .subpixel_bits = 8};

/// Right-handed world with z/w in [0, 1] and the first texel at the top. It fits WebGPU in three.js and glTF viewers.
/// It also fits right-handed worlds under Direct3D. For a left-handed world in WebGPU or Metal use direct3d_clip_space.
inline constexpr clip_space webgpu_clip_space{.range = depth_range::zero_to_one, .origin = texture_origin::top};
/// Clip space of Metal, the same as that of WebGPU.
inline constexpr clip_space metal_clip_space = webgpu_clip_space;

/// Left-handed world with y up, reversed depth and the first texel at the top. It counts on 4 sub-pixel bits, as Unity
/// draws with Metal and Vulkan too.
/// Under OpenGL z/w is in [-1, 1], depth is forward, and the first texel is at the bottom.
inline constexpr clip_space unity_clip_space{.hand = handedness::left,
                                             .range = depth_range::zero_to_one,
                                             .direction = depth_direction::reversed,
                                             .origin = texture_origin::top};
/// Clip space of Unity under OpenGL.
inline constexpr clip_space unity_opengl_clip_space{.hand = handedness::left, .range = depth_range::minus_one_to_one};

/// Unity's clip space, in a world whose up axis is z: pass .up = {0, 0, 1} to the setup functions.
inline constexpr clip_space unreal_clip_space = unity_clip_space;

/// Right-handed world with reversed depth and the first texel at NDC y = -1, for Godot 4.3 and later.
inline constexpr clip_space godot_clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed};

/// Right-handed world with z/w in [0, 1] and the first texel at the bottom. For maps that no API draws, as on the CPU.
inline constexpr clip_space cpu_clip_space{.range = depth_range::zero_to_one, .subpixel_bits = 8};

/// Name and value of each API's and engine's clip space.
struct named_clip_space {
    std::string_view name;
    clip_space value;
};
/// Clip spaces of the APIs and engines by name.
inline constexpr named_clip_space clip_spaces[]{{"opengl_clip_space", opengl_clip_space},
                                                {"vulkan_clip_space", vulkan_clip_space},
                                                {"direct3d_clip_space", direct3d_clip_space},
                                                {"webgpu_clip_space", webgpu_clip_space},
                                                {"metal_clip_space", metal_clip_space},
                                                {"unity_clip_space", unity_clip_space},
                                                {"unity_opengl_clip_space", unity_opengl_clip_space},
                                                {"unreal_clip_space", unreal_clip_space},
                                                {"godot_clip_space", godot_clip_space}};

namespace detail {

[[noreturn]] inline void refuse_unset(const char* function, const char* argument) {
    std::string names = "Use ";
    for (const named_clip_space& each : clip_spaces) names.append(each.name).append(", ");
    refuse(function, argument, "given", "unset", names.append("or cpu_clip_space where no API draws."));
}

/// Reports an unset clip space, in the name of the function that takes it as an argument.
constexpr void require_given(clip_space clip, const char* function, const char* argument = "clip") {
    if (clip.range == depth_range::unset) refuse_unset(function, argument);
}

}  // namespace detail

/// Depth of the far plane, the value to clear a map to.
/// @exactness   A: 1, or 0 where depth is reversed
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
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
)GLSL",
};

inline constexpr const snippet* clip_space_snippets[]{&cleared_depth};

}  // namespace glsl
}  // namespace umbrage
