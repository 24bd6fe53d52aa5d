// SPDX-License-Identifier: MIT
//
// What the depth pass draws.
//
//     umbrage::mesh_view mesh{positions, triangles};
//
#pragma once

#include <span>

#include <glm/vec3.hpp>

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
/// still clips.
enum class near_plane { clips, clamps };

}  // namespace umbrage
