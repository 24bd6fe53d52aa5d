// SPDX-License-Identifier: MIT
//
// Meshes for the depth pass: triangles, drawn once or as instances, each with its matrix.
//
//     umbrage::mesh_view mesh{positions, triangles};
//
// Also called: depth clamp, GL_DEPTH_CLAMP, depthClipEnable (near_plane).
//
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {

/// Triangles with three indices into the positions each. The view does not own them.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

/// Faces to leave out. Front faces are counter-clockwise in NDC with x to the right and y up, as in most right-handed
/// worlds. In most left-handed worlds they are clockwise: exchange front and back there.
enum class cull_mode { none, front, back };

/// Treatment of casters in front of the near plane: clipped, or clamped to the near plane (pancaking).
///
/// Clamped casters between the light and a near plane at the receivers still cast shadows. GPUs call it depth clamp,
/// but here the far plane still clips. A clamped caster has the near plane's depth. A receiver nearer to that plane
/// than its bias is lit behind any such caster. Fits without casters need a margin above the largest bias.
enum class near_plane { clips, clamps };

/// Matrix with which an instance of a mesh is drawn.
/// @param world_to_clip   projection * view
/// @param model           model to world
/// @exactness             the product in double, rounded once. Far from the world's origin a float product would lose
///                        the digits that remain after the camera's or the light's position is subtracted
template <class = detail::on_use>
[[nodiscard]] glm::mat4 model_to_clip(const glm::mat4& world_to_clip, const glm::mat4& model) {
    return glm::mat4(glm::dmat4(world_to_clip) * glm::dmat4(model));
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
