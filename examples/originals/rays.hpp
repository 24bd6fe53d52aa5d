// SPDX-License-Identifier: MIT
//
// Shadows by rays: slow, and independent of everything that the shadow map does. Told to by --rays, the programs
// compare themselves with it.
#pragma once

#include <umbrage/image.hpp>

#include "stage.hpp"

namespace example {

/// --rays: whether a shadow is where it belongs, away from edges by as much as filter and bias reach.
/// @param reach  how far they may move a shadow's edge, texels
/// @throws std::runtime_error  it is not, or no place is far enough from edges to tell
void compare_with_rays(const stage& on, const light& l, const umbrage::image<float>& visibility, int map_size,
                       float reach);

}  // namespace example
