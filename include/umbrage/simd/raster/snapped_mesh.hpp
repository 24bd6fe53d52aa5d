// SPDX-License-Identifier: MIT
//
// A mesh on the grid of an image, some ten thousand triangles at a time: their vertices projected and snapped, they
// themselves clipped and handed out in batches, in the mesh's order or band by band of the image's rows.
//
//     snapped_mesh snapped(size, mesh, world_to_clip, clip, cull_mode::none, near_plane::clips);
//     snapped.for_each_chunk(serial{}, [&] {
//         snapped.for_each_batch([&](const triangles& batch) { ... });
//     });
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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
#include <umbrage/simd/raster/triangles.hpp>
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

    /// Of which nothing is kept.
    void make(std::size_t count) {
        if (count <= count_) return;
        delete[] data_;
        data_ = nullptr;
        data_ = new snapped_vertex[count];
        count_ = count;
    }
    [[nodiscard]] snapped_vertex* data() { return data_; }
    [[nodiscard]] const snapped_vertex& operator[](std::size_t i) const { return data_[i]; }

private:
    snapped_vertex* data_ = nullptr;
    std::size_t count_ = 0;
};

/// The triangles of a mesh, chunk by chunk.
class snapped_mesh {
public:
    /// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
    snapped_mesh(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                 cull_mode cull, near_plane at_near)
        : mesh_(mesh), size_(size), cull_(cull), at_near_(at_near), project_(world_to_clip, clip, size) {
        if (mesh.triangles.empty()) return;
        if (indices(0, mesh.triangles.size()).highest >= mesh.positions.size())
            detail::fail("umbrage::rasterize: a triangle's index is out of range");
        if (size.x == 0 || size.y == 0 || !all_finite(world_to_clip)) mesh_.triangles = {};
    }

    /// @param use   (), which draws the chunk
    template <class ParallelFor, class Use>
    void for_each_chunk(ParallelFor&& parallel, const Use& use) {
        // As many vertices as a cache holds; with threads more, which are then started less often.
        constexpr std::size_t step = is_serial<ParallelFor> ? 1 << 16 : 1 << 20;
        for (std::size_t first = 0; first < mesh_.triangles.size(); first += step) {
            first_ = static_cast<unsigned>(first);
            last_ = static_cast<unsigned>(std::min(first + step, mesh_.triangles.size()));
            snap_vertices(parallel);
            use();
        }
    }

    /// The chunk in the mesh's order, all over the image.
    /// @param draw   (const triangles&)
    template <class Draw>
    void for_each_batch(const Draw& draw) const {
        for_each_batch(
            {{0, 0}, size_}, last_ - first_, [this](std::size_t k) { return first_ + unsigned(k); }, draw);
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

    struct index_range {
        unsigned lowest, highest;
    };

    [[nodiscard]] index_range indices(std::size_t first, std::size_t last) const {
        index_range range{~0u, 0u};
        on_best_isa([&](auto) UMBRAGE_INLINE {
            const glm::uvec3* t = mesh_.triangles.data() + first;
            unsigned low = ~0u, high = 0;
            for (; first + block <= last; first += block, t += block)
                for (int i = 0; i < block; ++i)
                    for (glm::length_t k = 0; k < 3; ++k) {
                        low = low < t[i][k] ? low : t[i][k];
                        high = high < t[i][k] ? t[i][k] : high;
                    }
            for (; first < last; ++first, ++t)
                for (glm::length_t k = 0; k < 3; ++k) low = std::min(low, (*t)[k]), high = std::max(high, (*t)[k]);
            range = {low, high};
        });
        return range;
    }

    /// The vertices that the chunk's triangles refer to, or each corner of theirs, whichever is less.
    template <class ParallelFor>
    void snap_vertices(ParallelFor&& parallel) {
        const auto [lowest, highest] = indices(first_, last_);
        const std::size_t corners = 3 * std::size_t(last_ - first_), range = std::size_t(highest) - lowest + 1;
        by_corner_ = corners < range;
        lowest_ = lowest;
        const std::size_t count = by_corner_ ? corners : range;
        vertices_.make((count + block - 1) / block * block);
        constexpr std::size_t blocks = 64;  // that a thread takes at a time
        parallel(static_cast<int>((count + blocks * block - 1) / (blocks * block)), [&](int first, int last) {
            for (std::size_t i = std::size_t(first) * blocks * block;
                 i < std::min(std::size_t(last) * blocks * block, count); i += block) {
                alignas(64) glm::vec3 positions[block];
                for (std::size_t k = 0; k < block; ++k) positions[k] = position(std::min(i + k, count - 1));
                project_.snap(positions, vertices_.data() + i);
            }
        });
    }

    [[nodiscard]] const glm::vec3& position(std::size_t i) const {
        return mesh_.positions[by_corner_ ? mesh_.triangles[first_ + i / 3][glm::length_t(i % 3)] : lowest_ + i];
    }

    [[nodiscard]] const snapped_vertex& vertex(unsigned triangle, glm::length_t corner) const {
        if (by_corner_) return vertices_[3 * std::size_t(triangle - first_) + std::size_t(corner)];
        return vertices_[mesh_.triangles[triangle][corner] - lowest_];
    }

    [[nodiscard]] static unsigned planes_crossed(const snapped_vertex& a, const snapped_vertex& b,
                                                 const snapped_vertex& c) {
        return planes_outside(a) | planes_outside(b) | planes_outside(c);
    }

    /// What is drawn of a triangle that crosses planes: the part behind the near plane, and where that clamps the part
    /// before it; nothing where it is outside of another plane, or not finite.
    /// @param use   (const clipped_polygon&), of three vertices or more
    template <class Use>
    void for_each_part(unsigned triangle, const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c,
                       unsigned crossed, const Use& use) const {
        constexpr unsigned before = 1u << projection::z_near;
        const unsigned beyond = planes_outside(a) & planes_outside(b) & planes_outside(c);
        if ((beyond & ~before) || (crossed & projection::nowhere)) return;
        const auto& t = mesh_.triangles[triangle];
        const auto h = [&](unsigned index) { return project_.homogeneous(mesh_.positions[index]); };
        const auto part = [&](near_side side) {
            const clipped_polygon polygon = clip_triangle(project_, h(t.x), h(t.y), h(t.z), crossed, side);
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
            const unsigned i = next(k);
            const snapped_vertex &a = vertex(i, 0), &b = vertex(i, 1), &c = vertex(i, 2);
            if (const unsigned crossed = planes_crossed(a, b, c)) {
                for_each_part(i, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                    for (std::size_t v = 1; int(v) + 1 < polygon.count; ++v)
                        add(polygon.vertices[0], polygon.vertices[v], polygon.vertices[v + 1], i);
                });
            } else {
                add(a, b, c, i);
            }
        }
        if (batch.count == 0) return;
        batch.set_up(bounds, cull_);
        draw(batch);
    }

    /// Whether triangles that follow each other lie in a band's rows, by a look at some.
    [[nodiscard]] bool is_coherent(int rows) const {
        constexpr unsigned looks = 64;
        const unsigned step = std::max(1u, (last_ - first_) / looks);
        unsigned near = 0, all = 0;
        for (unsigned i = first_; i + 1 < last_; i += step, ++all) {
            const int here = vertex(i, 0).y >> 8, next = vertex(i + 1, 0).y >> 8;
            near += next - here < rows && here - next < rows;
        }
        return 4 * near >= 3 * all;
    }

    /// Rows that a triangle may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] glm::ivec2 rows(unsigned triangle) const {
        const snapped_vertex &a = vertex(triangle, 0), &b = vertex(triangle, 1), &c = vertex(triangle, 2);
        std::int32_t lowest = std::min({a.y, b.y, c.y}), highest = std::max({a.y, b.y, c.y});
        if (const unsigned crossed = planes_crossed(a, b, c)) {
            lowest = std::numeric_limits<std::int32_t>::max(), highest = std::numeric_limits<std::int32_t>::min();
            for_each_part(triangle, a, b, c, crossed, [&](const clipped_polygon& polygon) {
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
        const unsigned pieces = (last_ - first_ + piece - 1) / piece;
        for (auto& list : lists_) list.clear();
        lists_.resize(std::size_t(pieces) * std::size_t(bands));
        parallel(static_cast<int>(pieces), [&](int from, int to) {
            for (unsigned i = first_ + unsigned(from) * piece; i < std::min(first_ + unsigned(to) * piece, last_);
                 ++i) {
                auto* const lists = lists_.data() + std::size_t((i - first_) / piece) * std::size_t(bands);
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
        if (k + later < list.size()) prefetch_line(&mesh_.triangles[list[k + later]]);
        if (k + soon < list.size())
            for (glm::length_t corner = 0; corner < 3; ++corner) prefetch_line(&vertex(list[k + soon], corner));
    }

    mesh_view mesh_;
    glm::ivec2 size_;
    cull_mode cull_;
    near_plane at_near_;
    projection project_;
    unsigned first_ = 0, last_ = 0, lowest_ = 0;  // triangles of the chunk; its lowest index
    bool by_corner_ = false;                      // three vertices a triangle, rather than a range of the mesh's
    unwritten_vertices vertices_;
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
