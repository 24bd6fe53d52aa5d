// SPDX-License-Identifier: MIT
//
// Depth pass of a dual paraboloid shadow map on the CPU.
//
//     for (int map : {0, 1}) umbrage::rasterize_dual_paraboloid(maps[map].view(), cut.view(), light, map);
//
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>

namespace umbrage {

/// Renders distances from the light into one of its two maps.
///
/// @param depth      light.map_size^2 texels, cleared or from an earlier pass
/// @param mesh       from tessellate: edges between its vertices are drawn as straight lines
/// @param light      from make_dual_paraboloid_light
/// @param map        0 or 1
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  another map; as rasterize_depth
/// @exactness        vertices C: square roots in double. Then as rasterize_depth
template <class ParallelFor = serial>
void rasterize_dual_paraboloid(image_view<float> depth, const mesh_view& mesh, const light_space<float>& light, int map,
                               ParallelFor&& parallel = {}) {
    detail::require(map == 0 || map == 1, "rasterize_dual_paraboloid", "map", "0 or 1", map);
    const glm::dvec3 position = -glm::dvec3(light.view[3]);
    const glm::dmat4 projection(light.projection);
    std::vector<glm::vec3> placed;
    // A kernel as wide as the border reaches from the circle's rim to here, with its corner in a diagonal.
    const double circle = projection[0][0], farthest = circle + std::sqrt(2.0) * (1.0 - circle);
    std::vector<bool> within;
    placed.reserve(mesh.positions.size());
    within.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec4 h = projection * dual_paraboloid_position(glm::dvec3(p) - position, double(map));
        placed.emplace_back(glm::dvec3(h) / h.w);
        within.push_back(h.w > 0 && glm::length(glm::dvec2(h)) <= farthest * h.w);
    }
    std::vector<glm::uvec3> drawn;
    for (const glm::uvec3& t : mesh.triangles) {
        bool is_drawn = false;  // false with all vertices beyond: directions there form a convex cone
        for (glm::length_t i = 0; i < 3; ++i) is_drawn = is_drawn || t[i] >= within.size() || within[t[i]];
        if (is_drawn) drawn.push_back(t);
    }
    rasterize_depth(depth, {placed, drawn}, glm::mat4(1), light.clip, cull_mode::none,
                    std::forward<ParallelFor>(parallel));
}

}  // namespace umbrage
