// SPDX-License-Identifier: MIT
//
// A mesh on the grid of an image: its vertices projected and snapped in blocks, its triangles clipped and handed out in
// batches, in the order that the caller chooses.
//
//     const projected_mesh projected(size, mesh, world_to_clip, clip, serial{});
//     projected.for_each_batch(triangles, bounds, cull_mode::none, [&](const triangle_batch& batch) { ... });
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/config.hpp>
#include <umbrage/images/mesh.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/raster/clip.hpp>
#include <umbrage/simd/raster/projection.hpp>
#include <umbrage/simd/raster/triangle_batch.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Room for vertices, each written before it is read: a vector would write them twice. (<memory>, which has a class
/// for this, brings the streams along.)
class unwritten_vertices {
public:
    unwritten_vertices() = default;
    unwritten_vertices(const unwritten_vertices&) = delete;
    unwritten_vertices& operator=(const unwritten_vertices&) = delete;
    ~unwritten_vertices() { delete[] data_; }

    void make(std::size_t count) { data_ = new snapped_vertex[count]; }
    [[nodiscard]] snapped_vertex& operator[](std::size_t i) { return data_[i]; }
    [[nodiscard]] const snapped_vertex& operator[](std::size_t i) const { return data_[i]; }

private:
    snapped_vertex* data_ = nullptr;
};

/// The vertices of a mesh on the grid of an image, and its triangles batch by batch.
class projected_mesh {
public:
    /// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
    template <class ParallelFor>
    projected_mesh(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                   ParallelFor&& parallel)
        : mesh_(mesh), project_(world_to_clip, clip, size) {
        for (const auto& t : mesh.triangles)
            if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size())
                detail::fail("umbrage::rasterize: a triangle's index is out of range");
        if (size.x == 0 || size.y == 0 || !all_finite(world_to_clip)) mesh_.triangles = {};
        if (mesh_.triangles.empty()) return;
        const std::size_t count = mesh.positions.size();
        vertices_.make((count + block - 1) / block * block);
        constexpr std::size_t piece = 64 * block;
        parallel(static_cast<int>((count + piece - 1) / piece), [&](int first, int last) {
            for (std::size_t i = std::size_t(first) * piece; i < std::min(std::size_t(last) * piece, count); i += block)
                project_block(i);
        });
    }

    /// Prefetches what comes after the k-th triangle of a list, whose triangles lie anywhere in the mesh. Inlined for
    /// the reason that prefetch_line() gives.
    UMBRAGE_INLINE void expect(std::span<const unsigned> list, std::size_t k) const {
        constexpr std::size_t soon = 16, later = 32;
        if (k + later < list.size()) prefetch_line(&mesh_.triangles[list[k + later]]);
        if (k + soon < list.size())
            for (glm::length_t corner = 0; corner < 3; ++corner)
                prefetch_line(&vertices_[mesh_.triangles[list[k + soon]][corner]]);
    }

    [[nodiscard]] unsigned triangle_count() const { return static_cast<unsigned>(mesh_.triangles.size()); }

    /// Rows that a triangle may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] std::pair<int, int> rows(unsigned triangle, int height) const {
        const auto& t = mesh_.triangles[triangle];
        const snapped_vertex &a = vertices_[t.x], &b = vertices_[t.y], &c = vertices_[t.z];
        auto [lowest, highest] = std::minmax({a.y, b.y, c.y});
        if (const unsigned crossed = planes_crossed(a, b, c)) {
            const auto polygon = clipped(t, a, b, c, crossed);
            if (polygon.count == 0) return {0, 0};
            lowest = highest = polygon.vertices[0].y;
            for (std::size_t i = 1; int(i) < polygon.count; ++i) {
                lowest = std::min(lowest, polygon.vertices[i].y);
                highest = std::max(highest, polygon.vertices[i].y);
            }
        }
        const auto rows = triangle_batch::rows(lowest, highest);
        return {std::max(rows.first, 0), std::min(rows.second, height)};
    }

    /// @param triangles  (f): calls f(unsigned triangle) for each
    /// @param draw       (const triangle_batch&), with the triangles in that order
    template <class Triangles, class Draw>
    void for_each_batch(const Triangles& triangles, const texel_bounds& bounds, cull_mode cull,
                        const Draw& draw) const {
        triangle_batch batch;
        const auto flush = [&] {
            batch.set_up();
            draw(batch);
            batch.count = 0;
        };
        triangles([&](unsigned i) {
            const auto& t = mesh_.triangles[i];
            const snapped_vertex &a = vertices_[t.x], &b = vertices_[t.y], &c = vertices_[t.z];
            const unsigned crossed = planes_crossed(a, b, c);
            if (crossed == 0) {
                batch.add(a, b, c, i, bounds, cull);
                if (batch.full()) flush();
                return;
            }
            const auto polygon = clipped(t, a, b, c, crossed);
            for (std::size_t k = 1; int(k) + 1 < polygon.count; ++k) {
                batch.add(polygon.vertices[0], polygon.vertices[k], polygon.vertices[k + 1], i, bounds, cull);
                if (batch.full()) flush();
            }
        });
        if (batch.count) flush();
    }

private:
    static constexpr unsigned nowhere = 1u << projection::planes;

    [[nodiscard]] static unsigned planes_crossed(const snapped_vertex& a, const snapped_vertex& b,
                                                 const snapped_vertex& c) {
        return planes_outside(a) | planes_outside(b) | planes_outside(c);
    }

    /// Of a triangle that crosses planes; empty where it is outside of one, or not finite.
    [[nodiscard]] clipped_polygon clipped(const glm::uvec3& t, const snapped_vertex& a, const snapped_vertex& b,
                                          const snapped_vertex& c, unsigned crossed) const {
        if ((planes_outside(a) & planes_outside(b) & planes_outside(c)) || (crossed & nowhere)) return {};
        const auto h = [&](unsigned index) { return project_.homogeneous(mesh_.positions[index]); };
        return clip_triangle(project_, h(t.x), h(t.y), h(t.z), crossed);
    }

    void project_block(std::size_t first) {
        alignas(64) glm::vec3 positions[block];
        for (std::size_t i = 0; i < block; ++i)
            positions[i] = mesh_.positions[std::min(first + i, mesh_.positions.size() - 1)];
        bool finite[block];
        for (std::size_t i = 0; i < block; ++i) {
            finite[i] = all_finite(positions[i]);
            if (!finite[i]) positions[i] = glm::vec3(0.0f);
        }
        alignas(64) snapped_vertex vertices[block];
        project_.snap(positions, vertices);
        for (std::size_t i = 0; i < block; ++i)
            vertices_[first + i] = finite[i] ? vertices[i] : outside_vertex(nowhere);
    }

    mesh_view mesh_;
    projection project_;
    unwritten_vertices vertices_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
