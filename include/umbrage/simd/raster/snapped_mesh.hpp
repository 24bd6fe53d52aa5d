// SPDX-License-Identifier: MIT
//
// Instances of a mesh on the grid of an image, some ten thousand triangles at a time: their vertices projected and
// snapped, they themselves clipped and handed out in batches, in the mesh's order or band by band of the image's rows.
//
//     snapped_mesh snapped(size, mesh, {&world_to_clip, 1}, clip, cull_mode::none, near_plane::clips);
//     snapped.for_each_chunk(serial{}, [&] {
//         snapped.for_each_batch([&](const triangles& batch) { ... });
//     });
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/config.hpp>
#include <umbrage/images/mesh.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/raster/clip.hpp>
#include <umbrage/simd/raster/projection.hpp>
#include <umbrage/simd/raster/snapped_chunk.hpp>
#include <umbrage/simd/raster/triangles.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// The triangles of a mesh, once for each of some matrices, chunk by chunk.
class snapped_mesh {
public:
    /// @param to_clip   of each instance; those that are not finite draw nothing
    /// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
    snapped_mesh(glm::ivec2 size, const mesh_view& mesh, std::span<const glm::mat4> to_clip, clip_space clip,
                 cull_mode cull, near_plane at_near)
        : mesh_(mesh), size_(size), cull_(cull), at_near_(at_near), chunk_(mesh) {
        require_drawable(size);
        if (mesh.triangles.empty()) return;
        if (indices_of(mesh.triangles).highest >= mesh.positions.size())
            detail::fail("umbrage::rasterize: a triangle's index is out of range");
        if (size.x == 0 || size.y == 0) return;
        for (const glm::mat4& matrix : to_clip)
            if (all_finite(matrix)) instances_.emplace_back(matrix, clip, size);
    }
    snapped_mesh(const snapped_mesh&) = delete;
    snapped_mesh& operator=(const snapped_mesh&) = delete;

    /// @param use   (), which draws the chunk
    template <class ParallelFor, class Use>
    void for_each_chunk(ParallelFor&& parallel, const Use& use) {
        // As many vertices as a cache holds; with threads more, which are then started less often.
        constexpr std::size_t step = is_serial<ParallelFor> ? 1 << 16 : 1 << 20;
        for (std::size_t instance = 0; instance < instances_.size(); instance += chunk_.instances())
            for (std::size_t first = 0; first < mesh_.triangles.size(); first += step) {
                chunk_.take(first, std::span<const projection>(instances_).subspan(instance), step);
                chunk_.snap(parallel);
                use();
            }
    }

    /// The chunk in the mesh's order, all over the image.
    /// @param draw   (const triangles&)
    template <class Draw>
    void for_each_batch(const Draw& draw) const {
        for_each_batch(
            {{0, 0}, size_}, chunk_.count(), [](std::size_t k) { return unsigned(k); }, draw);
    }

    /// The chunk band by band, where that keeps texels in the cache or lets threads draw side by side; else as above.
    template <class ParallelFor, class Draw>
    void for_each_batch_in_bands(ParallelFor&& parallel, const Draw& draw) {
        const int rows = std::clamp(band_texels / size_.x, 1, band_rows), bands = (size_.y + rows - 1) / rows;
        if (is_serial<ParallelFor> && (bands == 1 || is_coherent(rows))) return for_each_batch(draw);
        sort_into_bands(rows, bands, parallel);
        parallel(bands, [&](int first, int last) {
            for (int band = first; band < last; ++band) {
                const texel_bounds bounds{{0, band * rows}, {size_.x, std::min((band + 1) * rows, size_.y)}};
                for (std::size_t i = std::size_t(band); i < lists_.size(); i += std::size_t(bands)) {
                    const std::vector<unsigned>& list = lists_[i];
                    const auto next = [&](std::size_t k) {
                        expect(list, k);
                        return list[k];
                    };
                    for_each_batch(bounds, list.size(), next, draw);
                }
            }
        });
    }

private:
    template <class ParallelFor>
    static constexpr bool is_serial = std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>;
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    static constexpr unsigned piece = 1 << 16;  // triangles that one thread sorts at a time

    [[nodiscard]] static unsigned planes_crossed(const snapped_vertex& a, const snapped_vertex& b,
                                                 const snapped_vertex& c) {
        return planes_outside(a) | planes_outside(b) | planes_outside(c);
    }

    /// What is drawn of a triangle that crosses planes: the part behind the near plane, and where that clamps the part
    /// before it; nothing where it is outside of another plane, or not finite.
    /// @param use   (const clipped_polygon&), of three vertices or more
    template <class Use>
    void for_each_part(const drawn_triangle& at, const snapped_vertex& a, const snapped_vertex& b,
                       const snapped_vertex& c, unsigned crossed, const Use& use) const {
        constexpr unsigned before = 1u << projection::z_near;
        const unsigned beyond = planes_outside(a) & planes_outside(b) & planes_outside(c);
        if ((beyond & ~before) || (crossed & projection::nowhere)) return;
        const auto h = [&](glm::length_t corner) { return chunk_.homogeneous(at, corner); };
        const auto part = [&](near_side side) {
            const clipped_polygon polygon = clip_triangle(chunk_.projection_of(at), h(0), h(1), h(2), crossed, side);
            if (polygon.count > 0) use(polygon);
        };
        if (!beyond) part(near_side::behind);
        if (at_near_ == near_plane::clamps && (crossed & before)) part(near_side::before);
    }

    /// @param next   (std::size_t k) -> the k-th triangle
    template <class Next, class Draw>
    void for_each_batch(const texel_bounds& bounds, std::size_t count, const Next& next, const Draw& draw) const {
        triangles batch;
        const auto add = [&](const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c, unsigned i) {
            batch.add(a, b, c, i);
            if (!batch.full()) return;
            batch.set_up(bounds, cull_);
            draw(batch);
            batch.count = 0;
        };
        for (std::size_t k = 0; k < count; ++k) {
            const drawn_triangle at = chunk_.place_of(next(k));
            const unsigned id = static_cast<unsigned>(at.triangle);
            const snapped_vertex &a = chunk_.vertex(at, 0), &b = chunk_.vertex(at, 1), &c = chunk_.vertex(at, 2);
            if (const unsigned crossed = planes_crossed(a, b, c)) {
                for_each_part(at, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                    for (std::size_t v = 1; int(v) + 1 < polygon.count; ++v)
                        add(polygon.vertices[0], polygon.vertices[v], polygon.vertices[v + 1], id);
                });
            } else {
                add(a, b, c, id);
            }
        }
        if (batch.count == 0) return;
        batch.set_up(bounds, cull_);
        draw(batch);
    }

    /// Whether triangles that follow each other lie in a band's rows, by a look at some.
    [[nodiscard]] bool is_coherent(int rows) const {
        constexpr unsigned looks = 64;
        const unsigned step = std::max(1u, chunk_.count() / looks);
        unsigned near = 0, all = 0;
        for (unsigned i = 0; i + 1 < chunk_.count(); i += step, ++all) {
            const int here = chunk_.vertex(chunk_.place_of(i), 0).y >> 8,
                      next = chunk_.vertex(chunk_.place_of(i + 1), 0).y >> 8;
            near += next - here < rows && here - next < rows;
        }
        return 4 * near >= 3 * all;
    }

    /// Rows that a triangle may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] glm::ivec2 rows(unsigned triangle) const {
        const drawn_triangle at = chunk_.place_of(triangle);
        const snapped_vertex &a = chunk_.vertex(at, 0), &b = chunk_.vertex(at, 1), &c = chunk_.vertex(at, 2);
        std::int32_t lowest = std::min({a.y, b.y, c.y}), highest = std::max({a.y, b.y, c.y});
        if (const unsigned crossed = planes_crossed(a, b, c)) {
            lowest = std::numeric_limits<std::int32_t>::max(), highest = std::numeric_limits<std::int32_t>::min();
            for_each_part(at, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                for (std::size_t i = 0; int(i) < polygon.count; ++i) {
                    lowest = std::min(lowest, polygon.vertices[i].y);
                    highest = std::max(highest, polygon.vertices[i].y);
                }
            });
            if (lowest > highest) return {0, 0};
        }
        const auto between = triangles::rows_between(lowest, highest);
        return {std::max(between.x, 0), std::min(between.y, size_.y)};
    }

    template <class ParallelFor>
    void sort_into_bands(int rows_a_band, int bands, ParallelFor&& parallel) {
        const unsigned pieces = (chunk_.count() + piece - 1) / piece;
        for (auto& list : lists_) list.clear();
        lists_.resize(std::size_t(pieces) * std::size_t(bands));
        parallel(static_cast<int>(pieces), [&](int from, int to) {
            for (unsigned i = unsigned(from) * piece; i < std::min(unsigned(to) * piece, chunk_.count()); ++i) {
                auto* const lists = lists_.data() + std::size_t(i / piece) * std::size_t(bands);
                const glm::ivec2 covered = rows(i);
                for (int band = covered.x / rows_a_band; band * rows_a_band < covered.y; ++band)
                    lists[band].push_back(i);
            }
        });
    }

    /// Prefetches what comes after the k-th triangle of a list, whose triangles lie anywhere in the chunk. Inlined for
    /// the reason that prefetch_line() gives.
    UMBRAGE_INLINE void expect(const std::vector<unsigned>& list, std::size_t k) const {
        constexpr std::size_t soon = 16, later = 32;
        if (k + later < list.size()) prefetch_line(&mesh_.triangles[chunk_.place_of(list[k + later]).triangle]);
        if (k + soon >= list.size()) return;
        const drawn_triangle at = chunk_.place_of(list[k + soon]);
        for (glm::length_t corner = 0; corner < 3; ++corner) prefetch_line(&chunk_.vertex(at, corner));
    }

    mesh_view mesh_;
    glm::ivec2 size_;
    cull_mode cull_;
    near_plane at_near_;
    std::vector<projection> instances_;
    snapped_chunk chunk_;
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
