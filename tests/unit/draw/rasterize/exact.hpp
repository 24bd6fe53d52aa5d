// SPDX-License-Identifier: MIT
//
// An oracle that knows neither edge functions with a bias nor floating point: positions, planes and depths are
// fractions of integers, and a sample on an edge is decided by moving it an infinitesimal step to the right and a yet
// smaller one down, which is what the top-left rule means.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace raster_scene {

__extension__ typedef __int128 wide;

// The oracle's vertex: clip coordinates x/d, y/d, z/d, w/d with integers x, y, z, w, so that d cancels.
struct exact_vertex {
    std::int64_t x, y, z, w;
    std::int64_t column = 0, row = 0;  // on the vertex grid

    void snap(glm::ivec2 size) {
        const auto nearest = [](std::int64_t numerator, std::int64_t denominator) {  // floor(n / d + 1/2)
            const std::int64_t n = 2 * numerator + denominator, d = 2 * denominator;
            return n / d - (n % d < 0);
        };
        column = nearest((x + w) * size.x * 128, w);
        row = nearest((y + w) * size.y * 128, w);
    }
};

struct exact_triangle {
    std::array<exact_vertex, 3> v;

    static std::int64_t cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
        return ax * by - ay * bx;
    }
    static int sign(std::int64_t a) { return (a > 0) - (a < 0); }

    std::int64_t area() const {
        return cross(v[1].column - v[0].column, v[1].row - v[0].row, v[2].column - v[0].column, v[2].row - v[0].row);
    }
    // twice the area that edge i and the texel's center span
    std::int64_t part(std::size_t i, glm::ivec2 texel) const {
        const auto &a = v[i], &b = v[(i + 1) % 3];
        return cross(b.column - a.column, b.row - a.row, texel.x * 256 + 128 - a.column, texel.y * 256 + 128 - a.row);
    }
    bool covers(glm::ivec2 texel) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = v[i], &b = v[(i + 1) % 3];
            int side = sign(part(i, texel));
            if (side == 0) side = -sign(b.row - a.row);        // the step to the right
            if (side == 0) side = -sign(b.column - a.column);  // the step down
            if (side == 0 || side != sign(area())) return false;
        }
        return true;
    }
    // sum of part * z / w over area; numbers here keep it below 2^120
    long double depth(glm::ivec2 texel) const {
        wide numerator = 0, denominator = area();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = v[i], &b = v[(i + 1) % 3], &c = v[(i + 2) % 3];
            numerator += wide(part((i + 1) % 3, texel)) * a.z * b.w * c.w;
            denominator *= a.w;
        }
        return static_cast<long double>(numerator) / static_cast<long double>(denominator);
    }
};

// world_to_clip for positions (x, y, w) / 64 with z = plane . (x, y, w) / 64: rows in small integers
struct exact_scene {
    glm::mat4 matrix{0.0f};
    std::array<int, 4> plane;

    explicit exact_scene(std::array<int, 4> z) : plane(z) {
        matrix[0][0] = matrix[1][1] = matrix[2][3] = 1.0f;
        for (int i = 0; i < 4; ++i) matrix[i][2] = float(plane[std::size_t(i)]) / 4096.0f;
    }
    // x, y, w in 1/64; z in 1/(64 * 4096)
    exact_vertex vertex(int x, int y, int w) const {
        return {std::int64_t(x) * 4096, std::int64_t(y) * 4096,
                std::int64_t(plane[0]) * x + std::int64_t(plane[1]) * y + std::int64_t(plane[2]) * w + plane[3] * 64,
                std::int64_t(w) * 4096};
    }
    static glm::vec3 position(int x, int y, int w) { return {float(x) / 64.0f, float(y) / 64.0f, float(w) / 64.0f}; }
};

}  // namespace raster_scene
