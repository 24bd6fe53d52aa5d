// SPDX-License-Identifier: MIT
//
// Depth pass on the CPU: triangles into a depth image. Each sample on a shared edge is covered exactly once.
//
//     umbrage::image<float> map({1024, 1024}, umbrage::cleared_depth(clip));
//     umbrage::rasterize_depth(map, {positions, triangles}, world_to_clip, clip);
//     umbrage::rasterize_depth(map, tree, model_matrices, world_to_clip, clip);  // a forest; culled: see instances.hpp
//
// A camera pass keeps the nearest triangle per texel, and then interpolates:
//
//     umbrage::rasterize(size, mesh, world_to_clip, clip, [&](glm::ivec2 texel, float z, unsigned triangle) {
//         if (z <= depth[texel]) depth[texel] = z, visible[texel] = triangle;
//     });
//     glm::vec3 weights = umbrage::barycentrics(size, mesh, world_to_clip, clip, texel, visible[texel]);
//
// Vertices are snapped to 1/256 texel, and edges are evaluated in integers at texel centers. Ties follow the top-left
// rule, with top and left as in NDC for both texture origins. Depth is a plane with rounded coefficients, so that every
// sample is computed exactly. No order of triangles or vertices, no threads and no instruction set changes a bit.
// Contraction to FMA may only move a clipped triangle's cut by 1/256 texel.
// Also called: software rasterizer (rasterize_depth, rasterize).
//
#pragma once

#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/barycentrics.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/raster/band_buffer.hpp>
#include <umbrage/draw/raster/depth_writer.hpp>
#include <umbrage/draw/raster/snapped_mesh.hpp>
#include <umbrage/draw/raster/triangles.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

/// Target for batches of triangles: a depth image, or bands of it. Each thread has a copy, and draws bands by it.
template <bool Forward>
class depth_target {
public:
    /// @param image   row 0 at the bottom
    explicit depth_target(image_view<float> image) : image_(image) {}

    void operator()(const triangles& batch) const { draw<Forward>(image_, 0, batch); }

    /// Draws batches into a band of rows.
    /// @param rows   first <= y < second, at least one row, to which nobody else draws meanwhile
    /// @param use    (draw), which calls draw(const triangles&) for batches within these rows
    template <class Use>
    void in_band(const glm::ivec2& rows, const Use& use) {
        buffer_.begin(image_.rows(rows.x, rows.y));
        use([&](const triangles& batch) {
            buffer_.expect(batch);
            draw<Forward>(buffer_.rows(), rows.x, batch);
        });
        buffer_.finish();
    }

private:
    image_view<float> image_;
    band_buffer<> buffer_;
};

template <class ParallelFor>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::dmat4> to_clip,
                     clip_space clip, cull_mode cull, ParallelFor&& parallel, near_plane at_near) {
    snapped_mesh snapped(depth.size, mesh, to_clip, clip, cull, at_near, parallel, "rasterize_depth");
    if (clip.origin == texture_origin::top && !depth.empty())
        depth = {depth.row(depth.size.y - 1), depth.size, -depth.stride};
    snapped.for_each_chunk(parallel, [&] {
        if (clip.direction == depth_direction::forward) snapped.for_each_batch(parallel, depth_target<true>(depth));
        else snapped.for_each_batch(parallel, depth_target<false>(depth));
    });
}

/// @param to_clip_of   (model) -> its matrix to clip space, in double
template <class ToClip, class ParallelFor>
void rasterize_instances(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                         const ToClip& to_clip_of, clip_space clip, cull_mode cull, ParallelFor&& parallel,
                         near_plane at_near) {
    std::vector<glm::dmat4> to_clip, turned;  // no instance is in both
    to_clip.reserve(instances.size());
    for (const glm::mat4& model : instances) {
        const bool turns = cull != cull_mode::none && is_mirrored(model);
        (turns ? turned : to_clip).push_back(to_clip_of(model));
    }
    rasterize_depth(depth, mesh, {to_clip.data(), to_clip.size()}, clip, cull, parallel, at_near);
    if (!turned.empty())
        rasterize_depth(depth, mesh, {turned.data(), turned.size()}, clip, mirrored(cull), parallel, at_near);
}

}  // namespace detail

/// Renders triangles into a depth image that holds the cleared depth or an earlier pass.
///
/// @param depth          image of at most 16384 x 16384 texels. clip.origin decides which row is the first
/// @param mesh           triangles. One with a NaN or infinite position is left out. One without area on the 1/256
///                       texel grid covers nothing
/// @param world_to_clip  projection * view
/// @param clip           clip space of the light; with reversed depth, larger depths win
/// @param cull           faces to leave out
/// @param parallel       cuts the work into pieces, see parallel.hpp: vertices, triangles, bands of rows
/// @param at_near        treatment of casters in front of the near plane
/// @edge        empty image: nothing happens. world_to_clip not finite: nothing is drawn
/// @throws std::invalid_argument  clip unset; an index out of range; a side of the image above 16384
/// @formula     the nearer of the stored depth and the plane's. Ties have the same bits. Nothing beyond the far plane,
///              never -0
/// @exactness   coverage A from the snapped vertices on; depth B, see draw/raster/triangles.hpp: set_up
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                     cull_mode cull = cull_mode::none, ParallelFor&& parallel = {},
                     near_plane at_near = near_plane::clips) {
    rasterize_depth(depth, mesh, glm::dmat4(world_to_clip), clip, cull, parallel, at_near);
}

/// The same with a matrix in double, which loses nothing far from the origin.
/// @exactness   coverage and depth B: products in double
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::dmat4& world_to_clip, clip_space clip,
                     cull_mode cull = cull_mode::none, ParallelFor&& parallel = {},
                     near_plane at_near = near_plane::clips) {
    detail::rasterize_depth(depth, mesh, {&world_to_clip, 1}, clip, cull, parallel, at_near);
}

/// Renders many instances of a mesh, whose vertices are not copied.
///
/// @param instances   model to world, one matrix each. An instance whose model_to_clip is not finite draws nothing
/// @param cull        faces of the mesh to leave out, also where an instance mirrors it
/// @exactness         the bits of one pass of the mesh under model_to_clip(world_to_clip, instance) each, in any order.
///                    Passes of mirrored instances cull the other faces (is_mirrored)
/// Other parameters as for the pass of a single mesh.
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                     const glm::mat4& world_to_clip, clip_space clip, cull_mode cull = cull_mode::none,
                     ParallelFor&& parallel = {}, near_plane at_near = near_plane::clips) {
    const auto to_clip = [&](const glm::mat4& model) { return glm::dmat4(model_to_clip(world_to_clip, model)); };
    detail::rasterize_instances(depth, mesh, instances, to_clip, clip, cull, parallel, at_near);
}

/// The same with a matrix in double, which loses nothing far from the origin.
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                     const glm::dmat4& world_to_clip, clip_space clip, cull_mode cull = cull_mode::none,
                     ParallelFor&& parallel = {}, near_plane at_near = near_plane::clips) {
    const auto to_clip = [&](const glm::mat4& model) { return world_to_clip * glm::dmat4(model); };
    detail::rasterize_instances(depth, mesh, instances, to_clip, clip, cull, parallel, at_near);
}

/// Calls a function for each covered sample between the near and the far plane, triangle by triangle.
///
/// @param size    size of the image in texels, each side at most 16384
/// @param sample  (glm::ivec2 texel, float depth, unsigned triangle); it does the depth test. For results that do not
///                depend on the triangles' order, compare the triangles where depths tie
/// Other parameters as for rasterize_depth.
template <class Sample>
void rasterize(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip, Sample&& sample,
               cull_mode cull = cull_mode::none, near_plane at_near = near_plane::clips) {
    const bool flipped = clip.origin == texture_origin::top;
    const glm::dmat4 to_clip(world_to_clip);
    detail::snapped_mesh snapped(size, mesh, {&to_clip, 1}, clip, cull, at_near, serial{}, "rasterize");
    snapped.for_each_chunk(serial{}, [&] {
        snapped.for_each_batch([&](const detail::triangles& batch) {
            for (int i = 0; i < batch.count; ++i) {
                const auto plane = batch.plane(i);
                batch.for_each_row(i, [&](int y, int first, int last) {
                    for (int x = first; x < last; ++x)
                        if (const double z = plane(x, y); z >= 0.0 && z <= 1.0)
                            sample(glm::ivec2(x, flipped ? size.y - 1 - y : y), z > 0.0 ? static_cast<float>(z) : 0.0f,
                                   batch.id[i]);
                });
            }
        });
    });
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
