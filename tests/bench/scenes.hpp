// SPDX-License-Identifier: MIT
//
// Meshes for the depth pass, and what a shadow mask of one of them needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/rasterize.hpp>

#include "data.hpp"

namespace bench {

struct mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    operator umbrage::mesh_view() const { return {positions, triangles}; }
};

/// Depth 0 .. 1 to OpenGL's -1 .. 1.
[[nodiscard]] inline glm::mat4 to_opengl_depth() {
    glm::mat4 m(1.0f);
    m[2][2] = 2.0f, m[3][2] = -1.0f;
    return m;
}

/// Triangles of half a square with that side, anywhere on the screen, from back to front so that all of them are drawn.
[[nodiscard]] inline mesh scattered(int count, float side) {
    std::mt19937 engine(7);
    const auto random = [&] { return static_cast<float>(engine() >> 8) * 0x1p-24f; };
    mesh m;
    for (int i = 0; i < count; ++i) {
        const float x = random() * (1920.0f - side), y = random() * (1080.0f - side);
        const float z = 0.9f - 0.8f * static_cast<float>(i) / static_cast<float>(count);
        for (const auto& corner : {glm::vec2(x, y), glm::vec2(x + side, y), glm::vec2(x, y + side)})
            m.positions.emplace_back(corner.x / 960.0f - 1.0f, corner.y / 540.0f - 1.0f, z);
        m.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return m;
}

/// Hills over [-1, 1] x [-1, 1] of 2 n n triangles.
[[nodiscard]] inline mesh hills(int n) {
    mesh m;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) {
            const glm::vec2 p(2.0f * static_cast<float>(x) / static_cast<float>(n) - 1.0f,
                              2.0f * static_cast<float>(y) / static_cast<float>(n) - 1.0f);
            m.positions.emplace_back(p.x, p.y, 0.1f * std::sin(12.0f * p.x) * std::cos(9.0f * p.y));
        }
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto i = static_cast<unsigned>(y * (n + 1) + x), above = i + static_cast<unsigned>(n) + 1;
            m.triangles.emplace_back(i, i + 1, above);
            m.triangles.emplace_back(i + 1, above + 1, above);
        }
    return m;
}

/// Hills seen from above under a slanting light: receivers in the light's map, and the same points for rays.
struct lit_hills {
    mesh scene;
    glm::vec3 to_light = glm::vec3(0.8f, 0.3f, 0.5f) / std::sqrt(0.98f);
    glm::mat4 world_to_light{0.0f};  ///< depth 0 .. 1
    umbrage::image<glm::vec3> receivers{screen};
    std::vector<glm::vec3> points = std::vector<glm::vec3>(receivers.texels().size());

    explicit lit_hills(int n) : scene(hills(n)) {
        const glm::vec3 right = glm::vec3(-0.3f, 0.8f, 0.0f) / std::sqrt(0.73f);
        const glm::vec3 up(to_light.y * right.z - to_light.z * right.y, to_light.z * right.x - to_light.x * right.z,
                           to_light.x * right.y - to_light.y * right.x);
        for (int i = 0; i < 3; ++i) {
            world_to_light[i][0] = right[i] / 1.5f, world_to_light[i][1] = up[i] / 1.5f;
            world_to_light[i][2] = -to_light[i] / 4.0f;
        }
        world_to_light[3] = {0.0f, 0.0f, 0.5f, 1.0f};

        glm::mat4 from_above(1.0f);
        from_above[2][2] = -1.0f, from_above[3][2] = 0.5f;  // depth 1/2 - height
        umbrage::rasterize(screen, scene, from_above, umbrage::cpu_clip_space,
                           [&](glm::ivec2 texel, float z, unsigned) {
                               const glm::vec3 p((static_cast<float>(texel.x) + 0.5f) / 960.0f - 1.0f,
                                                 (static_cast<float>(texel.y) + 0.5f) / 540.0f - 1.0f, 0.5f - z);
                               const glm::vec4 c = world_to_light * glm::vec4(p, 1.0f);
                               receivers[texel] = {(c.x + 1.0f) * 1024.0f, (c.y + 1.0f) * 1024.0f, c.z - 0.004f};
                               points[std::size_t(texel.y) * 1920 + std::size_t(texel.x)] = p + to_light * 0.016f;
                           });
    }

    /// The light's map: bench::map_size texels.
    void draw(umbrage::image<float>& map) const {
        std::ranges::fill(map.texels(), 1.0f);
        umbrage::rasterize_depth(map, scene, world_to_light, umbrage::cpu_clip_space);
    }
};

}  // namespace bench
