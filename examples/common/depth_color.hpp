// SPDX-License-Identifier: MIT
//
// Depths as people see them: dark near the light, pale far away, in even steps of brightness; gray where nothing is.
//
//     const glm::vec3 color = example::depth_color(stretch(depth));
//
#pragma once

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace example {

/// @param v   from 0 to 1, near to far
/// @return    sRGB, from 0 to 1
[[nodiscard]] inline glm::vec3 depth_color(float v) {
    return glm::mix(glm::vec3(0.05f, 0.07f, 0.13f), glm::vec3(0.97f, 0.94f, 0.86f), v);
}

/// Of texels that nothing was drawn to.
inline constexpr glm::vec3 no_depth_color{0.5f, 0.5f, 0.5f};

}  // namespace example
