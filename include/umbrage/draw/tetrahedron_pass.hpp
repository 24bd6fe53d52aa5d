// SPDX-License-Identifier: MIT
//
// Depth pass of a tetrahedron shadow map on the CPU.
//
//     umbrage::rasterize_tetrahedron(map.view(), mesh, umbrage::make_tetrahedron_light(light));
//     umbrage::rasterize_tetrahedron(map.view(), tree, model_matrices, umbrage::make_tetrahedron_light(light));
//
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/tetrahedron.hpp>

namespace umbrage {

/// Renders each face's depths into its triangle of the map, as tetrahedron_face_of places it, and nowhere else.
///
/// @param depth      light.map_size^2 texels, cleared or from an earlier pass
/// @param instances  model to world, one matrix each
/// @param faces      from make_tetrahedron_light, each on its own triangle
/// @throws std::invalid_argument  as rasterize_depth; depth not square
/// @exactness        the bits of rasterize_depth, with the product of projection and view in double
/// Other parameters as for rasterize_depth.
template <real T, class ParallelFor = serial>
void rasterize_tetrahedron(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                           const std::array<light_space<T>, 4>& faces, cull_mode cull = cull_mode::none,
                           ParallelFor&& parallel = {}) {
    detail::require(depth.size.x == depth.size.y, "rasterize_tetrahedron", "depth.size", "square", depth.size);
    const auto side = static_cast<float>(depth.size.x);
    image<float> drawn(depth.size);
    for (int i = 0; i < 4; ++i) {
        const light_space<T>& face = faces[static_cast<std::size_t>(i)];
        for (int y = 0; y < depth.size.y; ++y) std::copy_n(depth.row(y), depth.size.x, drawn.view().row(y));
        rasterize_depth(drawn.view(), mesh, instances, glm::dmat4(face.projection) * glm::dmat4(face.view), face.clip,
                        cull, parallel);
        for (glm::ivec2 texel{0}; texel.y < depth.size.y; ++texel.y)
            for (texel.x = 0; texel.x < depth.size.x; ++texel.x)
                if (tetrahedron_face_of(glm::vec2(texel), side) == i) depth[texel] = drawn[texel];
    }
}

/// Renders a mesh whose positions are in the world.
/// Parameters as for the pass of instances.
template <real T, class ParallelFor = serial>
void rasterize_tetrahedron(image_view<float> depth, const mesh_view& mesh, const std::array<light_space<T>, 4>& faces,
                           cull_mode cull = cull_mode::none, ParallelFor&& parallel = {}) {
    const glm::mat4 in_place(1);
    rasterize_tetrahedron(depth, mesh, std::span(&in_place, 1), faces, cull, parallel);
}

}  // namespace umbrage
