// SPDX-License-Identifier: MIT
//
// Contents of a setup's maps, in the corner of a picture.
//
//     example::overlay_maps(picture, view, setup.place(view));
//
#pragma once

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include "setups.hpp"

namespace example {

/// Draws each map as the light sees it, farther is lighter, side by side from the top left corner on; of pages the
/// root; paraboloids where they get 16 texels.
/// @param maps   maps in umbrage's default clip space; without matrices they are a lamp's paraboloids
void overlay_maps(umbrage::image_view<glm::u8vec3> picture, const lit_view& v, const placed_maps& maps);

}  // namespace example
