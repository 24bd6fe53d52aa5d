// SPDX-License-Identifier: MIT
//
// Text over the picture.
//
//     hud.draw("Radeon 8500 ShadowMap\n", {12, 204}, {960, 640});
//
#pragma once

#include <string>

#include "gl.hpp"

namespace viewer {

class hud {
public:
    hud();
    /// @param from   pixels from the top left corner of the current framebuffer;   size  of it
    void draw(const std::string& text, glm::ivec2 from, glm::ivec2 size) const;

private:
    program program_;
    handle<buffer_kind> corners_;
};

}  // namespace viewer
