// SPDX-License-Identifier: MIT
//
// The depth pass of a dual paraboloid map on the CPU.
//
//     for (int map : {0, 1}) umbrage::rasterize_dual_paraboloid(maps[map].view(), cut.view(), light, map);
//
#pragma once

#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/images/mesh.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>

namespace umbrage {

/// Renders distances from the light into one of its two maps.
///
/// @param depth      of light.map_size^2 texels, cleared or of an earlier pass
/// @param mesh       as tessellate cuts it: between its vertices places and distances are straight lines' here
/// @param light      make_dual_paraboloid_light's
/// @param map        0 or 1
/// @throws std::invalid_argument  as rasterize_depth
/// @exactness        of vertices C, square roots in double; then as rasterize_depth
template <class ParallelFor = serial>
void rasterize_dual_paraboloid(image_view<float> depth, const mesh_view& mesh, const light_space<float>& light, int map,
                               ParallelFor&& parallel = {}) {
    const glm::dvec3 position = -glm::dvec3(light.view[3]);
    const glm::dmat4 projection(light.projection);
    std::vector<glm::vec3> placed;
    std::vector<bool> within;  // the map's square, out to whose edges its circle and border go
    placed.reserve(mesh.positions.size());
    within.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec4 h = projection * dual_paraboloid_position(glm::dvec3(p) - position, double(map));
        placed.emplace_back(glm::dvec3(h) / h.w);
        within.push_back(h.w > 0 && glm::length(glm::dvec2(h)) <= h.w);
    }
    std::vector<glm::uvec3> drawn;
    for (const glm::uvec3& t : mesh.triangles) {
        bool is_drawn = false;  // not so with all vertices beyond the circle: directions there are a convex cone's
        for (glm::length_t i = 0; i < 3; ++i) is_drawn = is_drawn || t[i] >= within.size() || within[t[i]];
        if (is_drawn) drawn.push_back(t);
    }
    rasterize_depth(depth, {{placed.data(), placed.size()}, {drawn.data(), drawn.size()}}, glm::mat4(1), light.clip,
                    cull_mode::none, std::forward<ParallelFor>(parallel));
}

}  // namespace umbrage
