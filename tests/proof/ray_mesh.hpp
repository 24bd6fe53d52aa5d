// SPDX-License-Identifier: MIT
//
// Triangles and lights for rays in double, which say what a shadow must find.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/mesh.hpp>

namespace proof {

/// Triangles that rays meet.
struct ray_mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    [[nodiscard]] umbrage::mesh_view view() const { return {positions, triangles}; }
    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::size_t k) const {
        const glm::uvec3 t = triangles[k];
        return {positions[t.x], positions[t.y], positions[t.z]};
    }
    [[nodiscard]] glm::vec3 normal(std::size_t k) const {
        const auto [a, b, c] = corners(k);
        return glm::vec3(glm::cross(b - a, c - a));
    }
    /// Distance at which a ray meets a triangle, in lengths of the way; NaN if it does not.
    /// @cite   Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997
    [[nodiscard]] double meets(std::size_t k, glm::dvec3 from, glm::dvec3 way) const {
        const auto [a, b, c] = corners(k);
        const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(way, ac), s = from - a, q = glm::cross(s, ab);
        const double det = glm::dot(ab, p), u = glm::dot(s, p) / det, v = glm::dot(way, q) / det;
        return u >= 0 && v >= 0 && u + v <= 1 ? glm::dot(ac, q) / det : std::nan("");
    }
};

/// Light for rays.
struct ray_light {
    bool is_point = false;
    glm::dvec3 from{0};  ///< the point, or a direction

    [[nodiscard]] glm::dvec3 way(glm::dvec3 p) const { return is_point ? from - p : from; }
};

}  // namespace proof
