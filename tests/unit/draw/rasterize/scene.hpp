// SPDX-License-Identifier: MIT
//
// Common parts of the rasterizer's tests: meshes, random numbers, a picture of either kind.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <umbrage/draw/rasterize.hpp>

namespace raster_scene {

using namespace umbrage;

inline constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();

struct mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    operator mesh_view() const { return {positions, triangles}; }

    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = static_cast<unsigned>(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.emplace_back(first, first + 1, first + 2);
    }
};

struct generator {
    std::mt19937 engine{20021};
    int operator()(int low, int high) {  // the same on every platform, unlike the standard's distributions
        return low + int(engine() % unsigned(high - low + 1));
    }
    float real(float low, float high) { return low + (high - low) * float(engine() >> 8) * 0x1p-24f; }
};

// x and y in 1/256 texel from the bottom left corner
inline glm::vec3 at(int x, int y, glm::ivec2 size, float z = 0.5f) {
    return {float(2 * x - 256 * size.x) / float(256 * size.x), float(2 * y - 256 * size.y) / float(256 * size.y), z};
}

inline image<int> count_samples(glm::ivec2 size, const mesh_view& m, const glm::mat4& matrix = glm::mat4(1.0f)) {
    image<int> count(size);
    rasterize(size, m, matrix, cpu_clip_space, [&](glm::ivec2 texel, float, unsigned) { ++count[texel]; });
    return count;
}

inline image<float> render(glm::ivec2 size, const mesh_view& m, const glm::mat4& matrix = glm::mat4(1.0f),
                           clip_space clip = cpu_clip_space, cull_mode cull = cull_mode::none) {
    image<float> depth(size, cleared_depth(clip));
    rasterize_depth(depth, m, matrix, clip, cull);
    return depth;
}

inline bool same_bits(const image<float>& a, const image<float>& b) {
    return std::equal(a.texels().begin(), a.texels().end(), b.texels().begin(), b.texels().end(), [](float p, float q) {
        return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
    });
}

inline bool all(const image<float>& a, float value) { return same_bits(a, image<float>(a.size(), value)); }

// triangles of all sorts: near ones and ones across the camera, beyond the far plane and the guard band
inline mesh soup(generator& random, int count) {
    mesh m;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 center(random.real(-2, 2), random.real(-2, 2), random.real(-6, 1));
        std::array<glm::vec3, 3> corner;
        for (auto& c : corner) {
            const float size = i % 7 == 0 ? 100.0f : 0.7f;
            c = center + glm::vec3(random.real(-size, size), random.real(-size, size), random.real(-size, size));
        }
        m.add(corner[0], corner[1], corner[2]);
    }
    return m;
}

// right-handed perspective, near 1/4, far 8, depth in [0, 1]
inline glm::mat4 perspective() {
    glm::mat4 m(0.0f);
    m[0][0] = m[1][1] = 1.0f;
    m[2][2] = -8.0f / 7.75f, m[3][2] = -2.0f / 7.75f;
    m[2][3] = -1.0f;
    return m;
}

}  // namespace raster_scene
