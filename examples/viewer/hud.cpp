// SPDX-License-Identifier: MIT
#include "hud.hpp"

#include <vector>

#include <letters.hpp>

namespace viewer {

hud::hud() : program_(text_stages(dialect())) {}

void hud::draw(const std::string& text, glm::ivec2 from, glm::ivec2 size) const {
    std::vector<glm::vec2> triangles;
    for (const auto& [low, high] : example::letters(text))
        triangles.insert(triangles.end(), {low, {high.x, low.y}, high, low, high, {low.x, high.y}});

    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    const auto bytes = static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::vec2));
    glBufferData(GL_ARRAY_BUFFER, bytes, triangles.data(), GL_STREAM_DRAW);
    for (GLuint i : {position, normal, face_normal, color}) glDisableVertexAttribArray(i);
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
