// SPDX-License-Identifier: MIT
//
// Shadows by rays: slow, and independent of everything that the shadow map does. Told to by --rays, the programs
// compare themselves with it.
#pragma once

#include <cstdint>

#include <umbrage/core/image.hpp>

#include "stage.hpp"

namespace example {

enum class by_rays : std::uint8_t { unknown, lit, shadow };

/// What rays tell of each pixel: nothing near edges of shadows, at the map's border and where it is dark anyway.
/// @param reach  how far filter and bias may move a shadow's edge, texels
[[nodiscard]] umbrage::image<by_rays> traced(const stage& on, const light& l, glm::ivec2 map_size, float reach);

/// --rays: whether a shadow is where it belongs, away from edges by as much as filter and bias reach.
/// @throws std::runtime_error  it is not, or no place is far enough from edges to tell
void compare_with_rays(const stage& on, const light& l, const umbrage::image<float>& visibility, glm::ivec2 map_size,
                       float reach);

}  // namespace example
