// SPDX-License-Identifier: MIT
//
// Shaders of the outdoor scene's passes, over instances.
//
//     viewer::program depth(viewer::outdoor_depth_stages());
//
#pragma once

#include <string_view>

#include "programs.hpp"
#include "session.hpp"

namespace viewer {

inline constexpr float cascade_fade_share = 0.1f;  ///< part over which the next cascade takes over

/// From the light, around an eye, from which points are told; into a lamp's paraboloid, or one face of its tetrahedron.
[[nodiscard]] stages outdoor_depth_stages(std::string_view placement);

/// Surfaces that the camera sees: the way there from the eye, and the direction of the normal or its opposite as an
/// integer of twice 12 bits. Below 0 there is no surface.
[[nodiscard]] stages outdoor_look_stages();
[[nodiscard]] glm::vec3 normal_of(float bits);

/// By its placement four layers by distance, pages of one, one map, warped or not, or a lamp's.
[[nodiscard]] stages outdoor_camera_stages(const session& s);

}  // namespace viewer
