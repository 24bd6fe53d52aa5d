// SPDX-License-Identifier: MIT
//
// Casters before the near plane of parallel rays. A depth pass clamps them to that plane. This is right for any filter
// but contact hardening, which takes their distance from the map.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage::detail {

/// Cuts a convex polygon to the side of a plane where dot(plane, vertex) is 0 or more.
inline void cut(std::vector<glm::dvec4>& polygon, const glm::dvec4& plane) {
    std::vector<glm::dvec4> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec4 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double at_a = glm::dot(plane, a), at_b = glm::dot(plane, b);
        if (at_a >= 0.0) kept.push_back(a);
        if ((at_a >= 0.0) != (at_b >= 0.0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon.swap(kept);
}

/// True where some part of a mesh lies in the map, but before its near plane by more than 2^-20 of the depths.
/// @param mesh    casters, whose indices are in range
/// @param light   light of the map, for the positions of the mesh
[[nodiscard]] inline bool has_clamped_casters(const mesh_view& mesh, std::span<const glm::mat4> instances,
                                              const light_space<double>& light) {
    const bool reversed = light.clip.direction == depth_direction::reversed;
    const double near_depth = reversed ? 1.0 : light.clip.range == depth_range::minus_one_to_one ? -1.0 : 0.0;
    const double nearer = reversed ? 1.0 : -1.0;
    const glm::dvec4 before(0.0, 0.0, nearer, -nearer * near_depth - 0x1p-20);
    std::vector<glm::dvec4> polygon;
    for (const glm::mat4& model : instances) {
        const glm::dmat4 to_clip = light.projection * light.view * glm::dmat4(model);
        for (const glm::uvec3 triangle : mesh.triangles) {
            polygon.clear();
            for (const glm::uint corner : {triangle.x, triangle.y, triangle.z})
                polygon.push_back(to_clip * glm::dvec4(glm::dvec3(mesh.positions[corner]), 1.0));
            cut(polygon, before);
            for (const double side : {1.0, -1.0}) {
                cut(polygon, {side, 0.0, 0.0, 1.0});
                cut(polygon, {0.0, side, 0.0, 1.0});
            }
            if (!polygon.empty()) return true;
        }
    }
    return false;
}

}  // namespace umbrage::detail
