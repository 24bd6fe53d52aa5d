// SPDX-License-Identifier: MIT
//
// Discs of points that engines' filters compare: rotated from pixel to pixel by noise.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace proof::picture {

/// Rotation by interleaved gradient noise, radians.
/// @cite   Jimenez: Next generation post processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014
[[nodiscard]] inline double noise_rotation(glm::ivec2 pixel) {
    const double along = 0.06711056 * (pixel.x + 0.5) + 0.00583715 * (pixel.y + 0.5);
    return 2 * std::numbers::pi * glm::fract(52.9829189 * glm::fract(along));
}

/// Points of Vogel's disc.
[[nodiscard]] inline std::vector<glm::dvec2> vogel_points(int count, double radius, double rotation) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < count; ++i) {
        const double distance = radius * std::sqrt((i + 0.5) / count);
        const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0)) + rotation;
        points.push_back(distance * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// Points of a spiral of eight, as in Bevy's temporal filter.
[[nodiscard]] inline std::vector<glm::dvec2> spiral_points(double radius, double rotation) {
    constexpr int eighths[]{3, 6, 1, 4, 7, 2, 5, 0};  // directions, in 1/8 of a circle
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 8; ++i) {
        const double angle = rotation + eighths[i] * std::numbers::pi / 4;
        points.push_back(radius * (1 - i / 8.0) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

}  // namespace proof::picture
