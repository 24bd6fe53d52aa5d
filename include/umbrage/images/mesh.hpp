// SPDX-License-Identifier: MIT
//
// What the depth pass draws: triangles, once or as instances, each under its matrix.
//
//     umbrage::mesh_view mesh{positions, triangles};
//
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {

/// Triangles that somebody else owns: three indices into the positions each.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

/// Which faces to leave out. The front goes counter-clockwise in NDC, x to the right and y up, as in most right-handed
/// worlds; where it goes clockwise, as in most left-handed ones, front and back change places.
enum class cull_mode { none, front, back };

/// What becomes of what lies before the near plane: it is clipped off, or drawn with that plane's depth, so that
/// casters between the light and a near plane at the receivers still cast. GPUs' depth clamp, but that the far plane
/// still clips. A clamped caster has the near plane's depth: a receiver nearer to that plane than its bias is lit
/// whatever stands before it. Fits without casters need a margin above the greatest bias.
enum class near_plane { clips, clamps };

/// The matrix that an instance of a mesh is drawn with.
/// @param model       model to world
/// @exactness         the product in double, rounded once: far from the world's origin a float product would lose what
///                    subtracting the camera's or the light's place leaves
template <class = detail::on_use>
[[nodiscard]] glm::mat4 model_to_clip(const glm::mat4& world_to_clip, const glm::mat4& model) {
    return glm::mat4(glm::dmat4(world_to_clip) * glm::dmat4(model));
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
