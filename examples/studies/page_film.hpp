// SPDX-License-Identifier: MIT
//
// Whether pages of an adaptive map pop while the camera moves: nowhere where its budget suffices, and counted where it
// does not. A table, and a film strip, pages.png.
#pragma once

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  the film strip cannot be written
void page_film(const options& o, const example::scene& scene);

}  // namespace shadow_render
