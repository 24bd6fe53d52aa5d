// SPDX-License-Identifier: MIT
//
// Points transformed by a matrix: the loss of depth in floats, and the distance from the image of an edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace proof {

/// Largest error in floats of the sums in a product of a matrix and a point, as z / w.
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
    if (!(b.w > 0)) return HUGE_VAL;
    const double behind = 1e-4 * b.w;
    if (a.w < behind) a += (b - a) * ((behind - a.w) / (b.w - a.w));
    const glm::dvec2 first = glm::dvec2(a) / a.w, way = glm::dvec2(b) / b.w - first, to = at - first;
    const double share = std::clamp(glm::dot(to, way) / std::max(glm::dot(way, way), 1e-12), 0.0, 1.0);
    return glm::length(to - share * way);
}

/// True when an edge of a triangle lies within some texels in the map, or the edge along which the near plane cuts it.
[[nodiscard]] inline bool sees_edge(const glm::dmat4& to_texels, bool reversed, const std::array<glm::dvec3, 3>& corner,
                                    glm::dvec2 at, double texels) {
    const auto beyond_near = [&](const glm::dvec4& h) { return reversed ? h.w - h.z : h.z; };
    std::vector<glm::dvec4> cut;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec4 a = to_texels * glm::dvec4(corner[i], 1), b = to_texels * glm::dvec4(corner[(i + 1) % 3], 1);
        if (distance_to_edge(at, a, b) < texels) return true;
        const double from = beyond_near(a), to = beyond_near(b);
        if ((from < 0) != (to < 0)) cut.push_back(a + (b - a) * (from / (from - to)));
    }
    return cut.size() == 2 && distance_to_edge(at, cut[0], cut[1]) < texels;
}

}  // namespace proof
