// SPDX-License-Identifier: MIT
//
// Data of the benchmarks: a map of boxes on a floor, and the receivers of a camera that looks along it.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/images/encode.hpp>

namespace bench {

inline constexpr glm::ivec2 map_size{2048, 2048}, screen{1920, 1080};
inline constexpr double map_texels = 2048.0 * 2048.0, pixels = 1920.0 * 1080.0;

/// Depths of a floor with boxes on it, exact in 11 bits so that packed and float maps give the same shadows.
[[nodiscard]] inline umbrage::image<float> make_map() {
    umbrage::image<float> map(map_size);
    for (int y = 0; y < map_size.y; ++y)
        for (int x = 0; x < map_size.x; ++x) {
            const int bx = x / 171, by = y / 141;
            const bool box = (bx * 7 + by * 5) % 6 == 0 && x % 171 < 90 && y % 141 < 80;
            const float depth = box ? 0.35f : 0.5f + 0.3f * static_cast<float>(y) / 2048.0f;
            map[{x, y}] = std::floor(depth * 2048.0f) / 2048.0f;
        }
    return map;
}

enum class order { coherent, random };

[[nodiscard]] inline umbrage::image<glm::vec3> make_receivers(order o) {
    umbrage::image<glm::vec3> receivers(screen);
    std::mt19937 engine(7);
    std::uniform_real_distribution<float> anywhere(1.0f, 2047.0f);
    for (int y = 0; y < screen.y; ++y)
        for (int x = 0; x < screen.x; ++x) {
            const float far = 1.0f / (0.25f + 0.75f * static_cast<float>(y) / 1080.0f);  // 1 .. 4
            glm::vec2 p(1024.0f + static_cast<float>(x - 960) * far * 0.26f, 1900.0f - 450.0f * far);
            p += glm::vec2(0.03f * static_cast<float>(y), 0.02f * static_cast<float>(x));
            if (o == order::random) p = {anywhere(engine), anywhere(engine)};
            receivers[{x, y}] = {p, 0.498f + 0.3f * p.y / 2048.0f};
        }
    return receivers;
}

}  // namespace bench
