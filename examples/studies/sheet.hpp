// SPDX-License-Identifier: MIT
//
// A contact sheet: pictures in rows, with or without a magnified part beside each, and text below it.
//
//     sheet page({480, 320}, 20, {"Every filter", "over one map"}, {200, 120});
//     page.add(picture, {"box", "RMS error 3.1 %"});
//
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <text.hpp>

namespace shadow_render {

using picture = umbrage::image<glm::u8vec3>;

using example::text;

class sheet {
public:
    static constexpr int columns = 4, lines = 3;  ///< of text below a picture

    /// @param size      of each picture
    /// @param center    of what is magnified, pixels of a picture; without one nothing is
    sheet(glm::ivec2 size, int pictures, const std::vector<std::string>& title, std::optional<glm::ivec2> center = {});

    void add(const picture& p, const std::vector<std::string>& text);

    [[nodiscard]] const picture& pixels() const { return pixels_; }

    /// Size of the part that is magnified.
    [[nodiscard]] static glm::ivec2 part(glm::ivec2 size);

private:
    void write(const std::vector<std::string>& text, glm::ivec2 at);

    glm::ivec2 size_, part_, first_;  ///< of the part that is magnified
    glm::ivec2 cell_;                 ///< a picture with all that belongs to it
    int top_, next_ = 0;
    picture pixels_;
};

}  // namespace shadow_render
