// SPDX-License-Identifier: MIT
//
// --light cascades: a directional light with a map for each of four parts of what the camera sees, all in one atlas.
// Besides the pictures of one map cascades.png, in which each cascade has a color.
#pragma once

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  a file cannot be written
void render_cascades(const options& o, const example::scene& scene);

}  // namespace shadow_render
