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

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>

#include <letters.hpp>

namespace pictures {

using picture = umbrage::image<glm::u8vec3>;

inline constexpr glm::u8vec3 paper{250, 249, 246}, ink{32, 34, 38}, pale_ink{110, 112, 116};

class canvas {
public:
    static constexpr int letter = 2, line = 10 * letter;  ///< pixels of a letter's unit, of a line

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

    void write(const std::string& text, glm::ivec2 at, glm::u8vec3 color = ink) {
        for (const auto& [low, high] : example::letters(text))
            fill(at + glm::ivec2(low * float(letter)), at + glm::ivec2(high * float(letter)), color);
    }

    [[nodiscard]] const picture& pixels() const { return pixels_; }

private:
    picture pixels_;
};

}  // namespace pictures
