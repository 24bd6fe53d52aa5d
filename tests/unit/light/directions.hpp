// SPDX-License-Identifier: MIT
//
// Common parts of tests of maps around a point light.
#pragma once

#include <random>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace directions {

/// Evenly over all directions, with lengths of their own.
inline glm::dvec3 any(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return {x, y, z};
}

/// Solid angle in steradians of a step of 1 in s and in t, from differences of coordinates around a direction.
/// @param coordinate   returns (s, t, map) of a direction: dvec3(dvec3). One map around the direction
template <class Coordinate>
double solid_angle(glm::dvec3 direction, const Coordinate& coordinate) {
    constexpr double step = 1e-6;
    const glm::dvec3 d = glm::normalize(direction);
    const glm::dvec3 side =
        glm::normalize(glm::cross(d, glm::abs(d.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 above = glm::cross(side, d);
    const auto along = [&](glm::dvec3 way) {
        return glm::dvec2(coordinate(d + step * way) - coordinate(d - step * way)) / (2 * step);
    };
    const glm::dvec2 u = along(side), v = along(above);
    return 1 / glm::abs(u.x * v.y - u.y * v.x);
}

}  // namespace directions
