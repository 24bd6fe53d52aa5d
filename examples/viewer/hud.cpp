// SPDX-License-Identifier: MIT
#include "hud.hpp"

#include <vector>

#include <stb/stb_easy_font.h>

namespace viewer {

hud::hud() : program_(text_stages(dialect())) {}

void hud::draw(const std::string& text, glm::ivec2 from, glm::ivec2 size) const {
    struct quad_corner {
        float x, y, z;
        unsigned char colour[4];
    };
    std::vector<quad_corner> quads(64 * text.size() + 4);  // a letter has up to 16 quads
    std::string characters = text;
    const int count = stb_easy_font_print(0, 0, characters.data(), nullptr, quads.data(),
                                          static_cast<int>(quads.size() * sizeof(quad_corner)));
    std::vector<glm::vec2> triangles;
    for (std::size_t first = 0; first < 4 * static_cast<std::size_t>(count); first += 4)
        for (std::size_t corner_of : {0u, 1u, 2u, 0u, 2u, 3u})
            triangles.emplace_back(quads[first + corner_of].x, quads[first + corner_of].y);

    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    const auto bytes = static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec2));
    glBufferData(GL_ARRAY_BUFFER, bytes, triangles.data(), GL_STREAM_DRAW);
    for (GLuint i : {position, normal, face_normal, colour}) glDisableVertexAttribArray(i);
    glEnableVertexAttribArray(corner);
    glVertexAttribPointer(corner, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glDisable(GL_DEPTH_TEST);
    constexpr float scale = 2;  // the font's letters are 7 pixels high
    program_.use().set("pixel", 2 * scale / glm::vec2(size));
    const auto once = [&](glm::vec2 offset, glm::vec4 ink) {
        program_.set("offset", glm::vec2(from) / scale + offset).set("ink", ink);
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
    };
    once({1, 1}, {0, 0, 0, 1});  // a shadow, fittingly: light letters on any ground
    once({0, 0}, {1, 1, 1, 1});
}

}  // namespace viewer
