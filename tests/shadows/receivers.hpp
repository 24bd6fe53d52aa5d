// SPDX-License-Identifier: MIT
//
// Receivers on the floor and the table of shadow_scene and near them, with any normals, some without one. Half of them
// lie about the edges of the table's shadows, and some in contact, below the floor by about a bias: there a number that
// is a little off shows.
#pragma once

#include <array>
#include <random>

#include <umbrage/core/image.hpp>

namespace shadows_in_gl {

/// The receivers' places and normals.
struct receivers {
    umbrage::image<glm::vec4> points, normals;

    explicit receivers(glm::ivec2 size) : points(size), normals(size) {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> anywhere(-12, 12), beside(-2, 2), below(-0.4f, 0), tilt(-1, 1);
        for (glm::vec4& p : points.texels()) {
            auto& place = random() % 2 == 0 ? anywhere : beside;
            const std::array heights{2.0f, below(random), 0.0f, 0.0f};
            p = {place(random), heights[random() % 4], place(random), 1};
        }
        for (glm::vec4& n : normals.texels())
            n = random() % 2 == 0 ? glm::vec4(0, 1, 0, 0) : glm::vec4(tilt(random), 2, tilt(random), 0);
        for (int i = 0; i < 40; ++i) normals[{i, 3}] = glm::vec4(0);
    }
};

}  // namespace shadows_in_gl
