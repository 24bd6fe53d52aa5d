// SPDX-License-Identifier: MIT
//
// Instances of a mesh on the grid of an image, a chunk of triangles at a time: their vertices projected and snapped,
// they themselves clipped and handed out in batches, in the mesh's order or band by band of the image's rows.
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
    template <class ParallelFor>
    snapped_mesh(glm::ivec2 size, const mesh_view& mesh, std::span<const glm::mat4> to_clip, clip_space clip,
                 cull_mode cull, near_plane at_near, ParallelFor&& parallel)
        : mesh_(mesh), size_(size), cull_(cull), at_near_(at_near), chunk_(mesh) {
        require_drawable(size);
        if (mesh.triangles.empty()) return;
        indices_.resize((mesh.triangles.size() + piece - 1) / piece);
        parallel(static_cast<int>(indices_.size()), [&](int first, int last) {
            for (std::size_t i = std::size_t(first); i < std::size_t(last); ++i)
                indices_[i] = indices_of(piece_of(mesh.triangles, i));
        });
        if (indices_from(0, mesh.triangles.size()).highest >= mesh.positions.size())
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
        // As many vertices as a cache holds; more with threads, which are then started less often, and where pieces
        // share their vertices with others, which would be snapped for each.
        const std::size_t step = is_serial<ParallelFor> && !shares_vertices() ? piece : several_pieces;
        for (std::size_t instance = 0; instance < instances_.size(); instance += chunk_.instances())
            for (std::size_t first = 0; first < mesh_.triangles.size(); first += step) {
                chunk_.take(first, std::span<const projection>(instances_).subspan(instance), step,
                            indices_from(first, step));
                chunk_.snap(parallel);
                use();
            }
    }

    /// The chunk in the mesh's order, all over the image.
    /// @param draw   (const triangles&)
    template <class Draw>
    void for_each_batch(const Draw& draw) const {
        for_each_batch(
            {{0, 0}, size_}, chunk_.count(), [](std::size_t k) { return unsigned(k); },
            [](const auto&...) { return true; }, draw);
    }

    /// The chunk band by band, where that keeps texels in the cache or lets threads draw side by side; else as above.
    template <class ParallelFor, class Draw>
    void for_each_batch_in_bands(ParallelFor&& parallel, const Draw& draw) {
        const int rows = std::clamp(band_texels / size_.x, 1, band_rows), bands = (size_.y + rows - 1) / rows;
        const bool coherent = is_coherent(rows);
        if (is_serial<ParallelFor> && (bands == 1 || coherent)) return for_each_batch(draw);
        const unsigned length = coherent ? run_of_many : 1;
        sort_into_bands(rows, bands, length, parallel);
        parallel(bands, [&](int first, int last) {
            for (int band = first; band < last; ++band) {
                const texel_bounds bounds{{0, band * rows}, {size_.x, std::min((band + 1) * rows, size_.y)}};
                const int bottom = bounds.first.y * subtexels, top = bounds.last.y * subtexels;
                for (std::size_t i = std::size_t(band); i < lists_.size(); i += std::size_t(bands)) {
                    const std::vector<unsigned>& list = lists_[i];
                    if (list.empty()) continue;
                    const std::size_t count = (list.size() - 1) * length + run_from(list.back(), length).size();
                    const auto next = [&](std::size_t k) {
                        if (coherent) return list[k / run_of_many] + unsigned(k % run_of_many);
                        expect(list, k);
                        return list[k];
                    };
                    const auto is_wanted = [&](const snapped_vertex& a, const snapped_vertex& b,
                                               const snapped_vertex& c) {
                        return std::max({a.y, b.y, c.y}) >= bottom && std::min({a.y, b.y, c.y}) <= top;
                    };
                    for_each_batch(bounds, count, next, is_wanted, draw);
                }
            }
        });
    }

private:
    template <class ParallelFor>
    static constexpr bool is_serial = std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>;
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    static constexpr unsigned piece = 1 << 16;  // triangles that one thread reads or sorts at a time
    static constexpr std::size_t several_pieces = 16 * piece;
    static constexpr unsigned run_of_many = 64;
    static constexpr unsigned before = 1u << projection::z_near;  // the bit of that plane

    /// Triangles of the chunk that follow each other.
    struct run {
        unsigned first, last;

        [[nodiscard]] unsigned size() const { return last - first; }
    };
    [[nodiscard]] run run_from(unsigned first, unsigned length) const {
        return {first, std::min(first + length, chunk_.count())};
    }

    [[nodiscard]] static std::span<const glm::uvec3> piece_of(std::span<const glm::uvec3> triangles, std::size_t i) {
        return triangles.subspan(i * piece, std::min(std::size_t(piece), triangles.size() - i * piece));
    }
    /// Of as many triangles, or of those that are left, from the first of a piece on.
    [[nodiscard]] index_range indices_from(std::size_t first, std::size_t count) const {
        index_range all;
        for (std::size_t i = first / piece; i < indices_.size() && i * piece < first + count; ++i)
            all.include(indices_[i]);
        return all;
    }

    /// Whether pieces reach farther over the mesh's vertices than they have corners, and several together do not.
    [[nodiscard]] bool shares_vertices() const {
        const index_range one = indices_from(0, piece), several = indices_from(0, several_pieces);
        return one.count() > 3 * piece && several.count() < 3 * std::min(several_pieces, mesh_.triangles.size());
    }

    [[nodiscard]] static unsigned planes_crossed(const snapped_vertex& a, const snapped_vertex& b,
                                                 const snapped_vertex& c) {
        return planes_outside(a) | planes_outside(b) | planes_outside(c);
    }

    /// Whether nothing is drawn of triangles whose corners are all outside of these planes, of which there may be none.
    [[nodiscard]] bool is_out_of_sight(unsigned planes) const {
        return at_near_ == near_plane::clips ? planes != 0 : (planes & ~before) != 0;
    }

    /// What is drawn of a triangle that crosses planes: the part behind the near plane, and where that clamps the part
    /// before it; nothing where it is outside of another plane, or not finite.
    /// @param use   (const clipped_polygon&), of three vertices or more
    template <class Use>
    void for_each_part(const drawn_triangle& at, const snapped_vertex& a, const snapped_vertex& b,
                       const snapped_vertex& c, unsigned crossed, const Use& use) const {
        const unsigned beyond = planes_outside(a) & planes_outside(b) & planes_outside(c);
        if (is_out_of_sight(beyond) || (crossed & projection::nowhere)) return;
        const auto h = [&](glm::length_t corner) { return chunk_.homogeneous(at, corner); };
        const auto part = [&](near_side side) {
            const clipped_polygon polygon = clip_triangle(chunk_.projection_of(at), h(0), h(1), h(2), crossed, side);
            if (polygon.count > 0) use(polygon);
        };
        if (!beyond) part(near_side::behind);
        if (at_near_ == near_plane::clamps && (crossed & before)) part(near_side::before);
    }

    /// @param next   (std::size_t k) -> the k-th triangle
    /// @param is_wanted   whether a triangle with these corners, which crosses no planes, may lie in the bounds' rows
    template <class Next, class IsWanted, class Draw>
    void for_each_batch(const texel_bounds& bounds, std::size_t count, const Next& next, const IsWanted& is_wanted,
                        const Draw& draw) const {
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
            } else if (is_wanted(a, b, c)) {
                add(a, b, c, id);
            }
        }
        if (batch.count == 0) return;
        batch.set_up(bounds, cull_);
        draw(batch);
    }

    /// Whether runs of many triangles lie in few bands, by a look at some.
    [[nodiscard]] bool is_coherent(int rows_a_band) const {
        constexpr unsigned looks = 16;
        const unsigned step = std::max(chunk_.count() / looks, run_of_many);
        int covered = 0, allowed = 0;
        for (unsigned i = 0; i < chunk_.count(); i += step, allowed += 2 * rows_a_band) {
            const glm::ivec2 some = rows(run_from(i, run_of_many));
            covered += std::max(some.y - some.x, 0);
        }
        return covered <= allowed;
    }

    /// Rows that triangles may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] glm::ivec2 rows(const run& some) const {
        if (some.size() == 1) return rows_one_by_one(some);  // registers pay for many
        const auto corners = chunk_.corners_of(some.first, some.last);
        if (corners.are_inside) return rows_between(corners.lowest, corners.highest);
        return is_out_of_sight(corners.outside) ? glm::ivec2(0, 0) : rows_one_by_one(some);
    }
    /// The same, of what planes leave of each. Not by its corners: where they are far, rounding may leave what lies
    /// between them.
    [[nodiscard]] glm::ivec2 rows_one_by_one(const run& some) const {
        std::int32_t lowest = std::numeric_limits<std::int32_t>::max(), highest = -lowest;
        const auto include = [&](const snapped_vertex& v) {
            lowest = std::min(lowest, v.y), highest = std::max(highest, v.y);
        };
        for (unsigned i = some.first; i < some.last; ++i) {
            const drawn_triangle at = chunk_.place_of(i);
            const snapped_vertex &a = chunk_.vertex(at, 0), &b = chunk_.vertex(at, 1), &c = chunk_.vertex(at, 2);
            if (const unsigned crossed = planes_crossed(a, b, c))
                for_each_part(at, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                    for (std::size_t v = 0; int(v) < polygon.count; ++v) include(polygon.vertices[v]);
                });
            else include(a), include(b), include(c);
        }
        return lowest > highest ? glm::ivec2(0, 0) : rows_between(lowest, highest);
    }
    [[nodiscard]] glm::ivec2 rows_between(std::int32_t lowest, std::int32_t highest) const {
        const auto between = triangles::rows_between(lowest, highest);
        return {std::max(between.x, 0), std::min(between.y, size_.y)};
    }

    /// Runs of a length into lists of the bands in which they may be seen.
    template <class ParallelFor>
    void sort_into_bands(int rows_a_band, int bands, unsigned length, ParallelFor&& parallel) {
        const unsigned pieces = (chunk_.count() + piece - 1) / piece;
        for (auto& list : lists_) list.clear();
        lists_.resize(std::size_t(pieces) * std::size_t(bands));
        parallel(static_cast<int>(pieces), [&](int from, int to) {
            for (unsigned i = unsigned(from) * piece; i < std::min(unsigned(to) * piece, chunk_.count()); i += length) {
                auto* const lists = lists_.data() + std::size_t(i / piece) * std::size_t(bands);
                const glm::ivec2 covered = rows(run_from(i, length));
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
    std::vector<index_range> indices_;          // of a piece
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band: where runs begin
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
