// SPDX-License-Identifier: MIT
//
// Inputs of somebody's fragment shader, to which no vertex shader gives values here.
#pragma once

#include <string>

namespace check {

/// The GLSL text with `uniform` for `in` where it declares inputs, so that they are 0. Parameters and lines stay.
[[nodiscard]] std::string with_uniform_inputs(const std::string& text);

}  // namespace check
