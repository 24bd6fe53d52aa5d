// SPDX-License-Identifier: MIT
//
// What a matrix makes of points: what floats lose of their depths, and how far from the image of an edge they lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace proof {

/// What the sums that a matrix times a point is may be off by in floats, as z / w.
/// @cite   Higham: Accuracy and stability of numerical algorithms, 2002: gamma_4
[[nodiscard]] inline float depth_rounding(const glm::mat4& m, glm::vec3 p) {
    const glm::vec4 h = m * glm::vec4(p, 1.0f), point(glm::abs(p), 1.0f);
    glm::vec4 sizes(0);
    for (glm::length_t i = 0; i < 4; ++i) sizes += glm::abs(m[i]) * point[i];
    return 0x1p-22f * (sizes.z + std::abs(h.z / h.w) * sizes.w) / h.w;
}

/// Distance to the image of the edge from a to b, both homogeneous; infinite where that lies behind.
[[nodiscard]] inline double distance_to_edge(glm::dvec2 at, glm::dvec4 a, glm::dvec4 b) {
    if (a.w > b.w) std::swap(a, b);
    constexpr double behind = 1e-3;
    if (b.w < behind) return HUGE_VAL;
    if (a.w < behind) a += (b - a) * ((behind - a.w) / (b.w - a.w));
    const glm::dvec2 first = glm::dvec2(a) / a.w, way = glm::dvec2(b) / b.w - first, to = at - first;
    const double share = std::clamp(glm::dot(to, way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
    return glm::length(to - share * way);
}

}  // namespace proof
