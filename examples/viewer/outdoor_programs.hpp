// SPDX-License-Identifier: MIT
//
// Shaders of the outdoor scene's passes, over instances.
//
//     viewer::program depth(viewer::outdoor_depth_stages());
//
#pragma once

#include <systems.hpp>

#include "programs.hpp"

namespace viewer {

inline constexpr float cascade_fade_share = 0.1f;  ///< of a cascade, over which the next one takes over

/// From the light, around an eye, from which points are told.
[[nodiscard]] stages outdoor_depth_stages();

/// What the camera sees: the way there from the eye, and as a whole number of twice 12 bits the direction of the
/// surface's normal or of the other side's; below 0 it is nothing.
[[nodiscard]] stages outdoor_look_stages();
[[nodiscard]] glm::vec3 normal_of(float bits);

/// @param cascaded     four layers by distance; else one map, warped or not
/// @param mask, tint   visibility alone; cascades in colours
[[nodiscard]] stages outdoor_camera_stages(const example::shadow_system& s, bool cascaded, bool mask, bool tint);

}  // namespace viewer
