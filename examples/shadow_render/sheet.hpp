// SPDX-License-Identifier: MIT
//
// A contact sheet: pictures in rows, a magnified part beside each and text below it.
//
//     sheet page({480, 320}, 20, {"Every filter", "over one map"}, {200, 120});
//     page.add(picture, {"box", "RMS error 3.1 %"});
//
#pragma once

#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/image.hpp>

namespace shadow_render {

using picture = umbrage::image<glm::u8vec3>;

class sheet {
public:
    static constexpr int columns = 4, lines = 3;  ///< of text below a picture

    /// @param size      of each picture
    /// @param centre    of what is magnified, pixels of a picture
    sheet(glm::ivec2 size, int pictures, const std::vector<std::string>& title, glm::ivec2 centre);

    void add(const picture& p, const std::vector<std::string>& text);

    [[nodiscard]] const picture& pixels() const { return pixels_; }

    /// Size of a picture with all that belongs to it, and of the part that is magnified.
    [[nodiscard]] static glm::ivec2 cell(glm::ivec2 size);
    [[nodiscard]] static glm::ivec2 part(glm::ivec2 size);

private:
    void write(const std::vector<std::string>& text, glm::ivec2 at);

    glm::ivec2 size_, first_;  ///< of the part that is magnified
    int top_, next_ = 0;
    picture pixels_;
};

}  // namespace shadow_render
