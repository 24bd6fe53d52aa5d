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

}  // namespace umbrage
