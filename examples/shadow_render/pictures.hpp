// SPDX-License-Identifier: MIT
//
// What comes out: map.png, the texels' bytes; depth.png, them decoded, in colors; visibility.png; picture.png.
#pragma once

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <shadow_map.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  a file cannot be written
void write(const options& o, const example::shadow_map& map, const umbrage::image<float>& visibility,
           umbrage::image<glm::u8vec3> lit);

}  // namespace shadow_render
