// SPDX-License-Identifier: MIT
//
// Points on a circle and rotations that no C library decides: scenes have the same floats everywhere.
//
//     const glm::vec2 at = example::on_circle(1.0 / 12);  // (cos, sin) of 30 degrees
//
#pragma once

#include <cmath>
#include <numbers>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace example {

/// (cos, sin) of an angle, by series in double that end below 2^-54.
/// @param turns   turns of the circle: 1 is 360 degrees; whole quarters give 0, 1 and -1
[[nodiscard]] inline glm::vec2 on_circle(double turns) {
    const double quarter = std::floor(4 * turns + 0.5), x = (turns - quarter / 4) * (2 * std::numbers::pi), y = x * x;
    double cosine = 1, sine = 1;
    for (double n = 16; n > 0; n -= 2) {
        cosine = 1 - y * cosine / (n * (n - 1));
        sine = 1 - y * sine / (n * (n + 1));
    }
    const glm::vec2 at(static_cast<float>(cosine), static_cast<float>(x * sine));
    switch (static_cast<int>(quarter - 4 * std::floor(quarter / 4))) {
        case 0: return at;
        case 1: return {-at.y, at.x};
        case 2: return -at;
        default: return {at.y, -at.x};
    }
}

/// A rotation about an axis, as glm::rotate has it.
/// @param axis   0 for x, 1 for y, 2 for z
[[nodiscard]] inline glm::mat4 rotation_about(int axis, double turns) {
    const glm::vec2 at = on_circle(turns);
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    glm::mat4 m(1);
    m[first][first] = m[second][second] = at.x;
    m[first][second] = at.y;
    m[second][first] = -at.y;
    return m;
}

}  // namespace example
