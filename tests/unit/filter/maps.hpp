// SPDX-License-Identifier: MIT
//
// Common parts of tests of filters: random maps and coordinates, and the simplest lookup of a texel.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>

/// Depths k / 1024, few enough different ones that ties are common.
inline umbrage::image<float> random_map(std::mt19937& random, glm::ivec2 size, int steps = 8) {
    umbrage::image<float> map(size);
    std::uniform_int_distribution<int> step(0, steps);
    for (float& d : map.texels()) d = static_cast<float>(step(random) * (1024 / steps)) / 1024.0f;
    return map;
}

/// Texel by 64-bit coordinates, clamped to the map: an oracle of its own.
inline double texel_at(const umbrage::image<float>& map, long long x, long long y) {
    const auto inside = [](long long v, int size) {
        return static_cast<std::size_t>(std::clamp<long long>(v, 0, size - 1));
    };
    return double(
        map.texels()[inside(y, map.size().y) * static_cast<std::size_t>(map.size().x) + inside(x, map.size().x)]);
}

/// Coordinates where things happen: inside and around the map, at texel edges and centers, a step beside them,
/// near the limits of texel space.
inline std::vector<float> awkward_coordinates(std::mt19937& random, int size) {
    std::vector<float> all{
        0.0f, -0.0f, 32767.0f, -32767.0f, std::nextafter(32768.0f, 0.0f), std::nextafter(-32768.0f, 0.0f)};
    for (int i = -3; i <= size + 3; ++i)
        for (float part : {0.0f, 0.5f, 0.25f, 1.0f / 256, 255.0f / 256}) {
            const float c = float(i) + part;
            all.insert(all.end(), {c, std::nextafter(c, 1e9f), std::nextafter(c, -1e9f)});
        }
    std::uniform_real_distribution<float> anywhere(-4, float(size) + 4);
    for (int i = 0; i < 100; ++i) all.push_back(anywhere(random));
    return all;
}

/// Coordinates that every filter takes as lit.
inline std::vector<glm::vec2> coordinates_outside_texel_space() {
    std::vector<glm::vec2> all;
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (float bad : {32768.0f, -32768.0f, 65536.0f, 1e30f, -1e30f, infinity, -infinity, nan, -nan})
        for (glm::vec2 c : {glm::vec2(bad, 1), glm::vec2(1, bad), glm::vec2(bad, bad)}) all.push_back(c);
    return all;
}
