// SPDX-License-Identifier: MIT
//
// Conventions as values: which way the camera looks, what depth means, where the first texel is.
// Passed explicitly everywhere; GLM's configuration macros are neither read nor needed.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .clip = umbrage::vulkan_clip_space});
//
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Of the world and of view space alike, as in lookAtRH and lookAtLH: the view is a rotation, never a mirror.
/// Seen from the light, x is to the right and y up; right looks down -z, left down +z. A mesh keeps its winding: what
/// goes clockwise for the light goes clockwise in NDC, y up.
enum class handedness { right, left };
enum class depth_range { unset, zero_to_one, minus_one_to_one };  ///< of z/w between the planes
enum class depth_direction { forward, reversed };                 ///< reversed: the near plane has the greater depth
enum class texture_origin { bottom, top };                        ///< where texel (0, 0) is: at NDC y = -1, or y = +1

/// Treatment of texels outside the map.
enum class outside_map {
    bordered,  ///< the far plane, as under a border sampler: all outside the map is lit. The default of whole maps
    clamped,   ///< the nearest texel inside: what tiles with a gutter and faces of cubes want
};

/// Nothing can guess it, and a wrong one makes everything lit: functions refuse one whose range is unset.
struct clip_space {
    handedness hand = handedness::right;
    depth_range range = depth_range::unset;
    depth_direction direction = depth_direction::forward;
    texture_origin origin = texture_origin::bottom;

    friend constexpr bool operator==(const clip_space&, const clip_space&) = default;
};

/// Right-handed world, z/w in [-1, 1], texels from the bottom. With glClipControl: vulkan_clip_space.
inline constexpr clip_space opengl_clip_space{.range = depth_range::minus_one_to_one};

/// Right-handed world, z/w in [0, 1]; the first texel is at NDC y = -1, which Vulkan draws at the top.
inline constexpr clip_space vulkan_clip_space{.range = depth_range::zero_to_one};

/// Left-handed world, as D3DXMatrixLookAtLH has it, z/w in [0, 1], texels from the top.
inline constexpr clip_space direct3d_clip_space{
    .hand = handedness::left, .range = depth_range::zero_to_one, .origin = texture_origin::top};

/// Right-handed world, z/w in [0, 1], texels from the top: WebGPU as three.js and glTF viewers use it, and right-handed
/// worlds under Direct3D. WebGPU and Metal have no hand of their own: for a left-handed world take direct3d_clip_space.
inline constexpr clip_space webgpu_clip_space{.range = depth_range::zero_to_one, .origin = texture_origin::top};
inline constexpr clip_space metal_clip_space = webgpu_clip_space;

/// Left-handed world, y up, depth reversed, texels from the top. Under OpenGL z/w is in [-1, 1], depth forward, and
/// texels start at the bottom.
inline constexpr clip_space unity_clip_space{.hand = handedness::left,
                                             .range = depth_range::zero_to_one,
                                             .direction = depth_direction::reversed,
                                             .origin = texture_origin::top};
inline constexpr clip_space unity_opengl_clip_space{.hand = handedness::left, .range = depth_range::minus_one_to_one};

/// As Unity's. The world's up is z: give set-ups .up = {0, 0, 1}.
inline constexpr clip_space unreal_clip_space = unity_clip_space;

/// Godot 4.3 and later: right-handed world, depth reversed, the first texel at NDC y = -1.
inline constexpr clip_space godot_clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed};

/// Right-handed world, z/w in [0, 1], texels from the bottom: where no API draws, as in tests and on the CPU.
inline constexpr clip_space cpu_clip_space{.range = depth_range::zero_to_one};

/// Clip spaces of APIs and engines, with their names.
struct named_clip_space {
    std::string_view name;
    clip_space value;
};
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

/// Refuses a clip space that nobody gave, in the name of a function whose argument it is.
constexpr void require_given(clip_space clip, const char* function, const char* argument = "clip") {
    if (clip.range == depth_range::unset) refuse_unset(function, argument);
}

}  // namespace detail

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
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
)GLSL",
};

inline constexpr const snippet* clip_space_snippets[]{&cleared_depth};

}  // namespace glsl
}  // namespace umbrage
