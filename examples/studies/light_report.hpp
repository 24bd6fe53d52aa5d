// SPDX-License-Identifier: MIT
//
// studies lights: how good every setup of the light is for the camera's view, as a table and on one sheet, lights.png.
// The greatest are those of surfaces all but parallel to the light, as on every ball.
#pragma once

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @throws std::runtime_error  the sheet cannot be written
void light_report(const options& o, const example::scene& scene);

}  // namespace shadow_render
