// SPDX-License-Identifier: MIT
//
// A page of pictures: parts side by side, and text.
//
//     canvas page({900, 400});
//     page.paste(picture, {8, 8});
//     page.write("acne", {8, 210});
//
#pragma once

#include <algorithm>
#include <string>

#include <glm/common.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/unorm.hpp>

#include "lettering.hpp"

namespace pictures {

using picture = umbrage::image<glm::u8vec3>;

inline constexpr glm::u8vec3 paper{250, 249, 246}, ink{32, 34, 38}, pale_ink{110, 112, 116};

class canvas {
public:
    static constexpr int line = line_height;  ///< pixels

    explicit canvas(glm::ivec2 size) : pixels_(size, paper) {}

    void paste(const picture& part, glm::ivec2 at) {
        for (int y = 0; y < part.size().y; ++y)
            std::copy_n(part.view().row(y), part.size().x, pixels_.view().row(at.y + y) + at.x);
    }

    /// Fills a rectangle, as far as the page has it.
    void fill(glm::ivec2 low, glm::ivec2 high, glm::u8vec3 color) {
        const glm::ivec2 to = glm::min(high, pixels_.size());
        for (int y = low.y; y < to.y; ++y)
            for (int x = low.x; x < to.x; ++x) pixels_[{x, y}] = color;
    }

    /// Writes a line of text, as far as the page has it.
    void write(const std::string& text, glm::ivec2 at, glm::u8vec3 color = ink) {
        const umbrage::image<float> covered = lettering(text);
        const glm::ivec2 size = glm::min(covered.size(), pixels_.size() - at);
        for (glm::ivec2 p{0}; p.y < size.y; ++p.y)
            for (p.x = 0; p.x < size.x; ++p.x) {
                const glm::vec3 mixed = glm::mix(glm::vec3(pixels_[at + p]), glm::vec3(color), covered[p]);
                pixels_[at + p] = umbrage::store_unorm(mixed / 255.0f);
            }
    }

    [[nodiscard]] const picture& pixels() const { return pixels_; }

private:
    picture pixels_;
};

}  // namespace pictures
