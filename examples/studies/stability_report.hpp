// SPDX-License-Identifier: MIT
//
// studies stability: whether cascades stand still while the camera moves and turns. A table, of double and float, of
// one matrix and of a rotation with an offset, here and 3 km from the origin; and a film strip, film.png. Then whether
// a sun that moves shows where warps begin and end, and whether pages pop: see sun_film.hpp, page_film.hpp.
#pragma once

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  a film strip cannot be written
void stability_report(const options& o, const example::scene& scene);

}  // namespace shadow_render
