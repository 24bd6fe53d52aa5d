// SPDX-License-Identifier: MIT
//
// Whether a sun that moves shows where a warp begins, where it ends and where another map takes its place: a table, and
// a film strip, sun.png.
#pragma once

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  the film strip cannot be written
void sun_film(const options& o, const example::scene& scene);

}  // namespace shadow_render
