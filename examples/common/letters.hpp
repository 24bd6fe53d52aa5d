// SPDX-License-Identifier: MIT
//
// Text as rectangles, for the studies' sheets and for OpenGL.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace example {

struct rectangle {
    glm::vec2 low, high;
};

/// Letters are 7 units high, a line is 12; the first begins at (0, 0), y grows downwards.
[[nodiscard]] std::vector<rectangle> letters(std::string text);

}  // namespace example
