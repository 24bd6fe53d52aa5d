// SPDX-License-Identifier: MIT
//
// Instances of a mesh on the grid of an image, chunk by chunk: vertices projected and snapped, triangles clipped and
// passed on in batches. Batches follow the mesh's order, or an order in which threads draw at the same time.
//
//     snapped_mesh snapped(size, mesh, {&world_to_clip, 1}, clip, cull_mode::none, at_near, serial{}, "rasterize");
//     snapped.for_each_chunk(serial{}, [&] {
//         snapped.for_each_batch([&](const triangles& batch) { ... });
//     });
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/raster/band_lists.hpp>
#include <umbrage/draw/raster/clip.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/draw/raster/snapped_chunk.hpp>
#include <umbrage/draw/raster/triangles.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Locks for rows of an image to which several threads draw: one thread at a time may draw to a row.
template <class = on_use>
class row_locks {
public:
    explicit row_locks(int height) : locks_(std::size_t(height / rows_a_lock + 1)) {}

    /// Runs `use` while no other thread draws to the rows.
    /// @param rows   first <= y < second, at least one row
    /// @param use    (); must not throw
    template <class Use>
    void hold(const glm::ivec2& rows, const Use& use) {
        const std::size_t first = std::size_t(rows.x / rows_a_lock), last = std::size_t((rows.y - 1) / rows_a_lock);
        // From the first on in every thread, so that no two threads wait for each other.
        for (std::size_t i = first; i <= last; ++i) take_lock(locks_[i].held);
        use();
        for (std::size_t i = first; i <= last; ++i) store_release(0, locks_[i].held);
    }

private:
    static constexpr int rows_a_lock = 16;

    struct alignas(64) lock {  // one cache line each: threads at other rows take none from each other
        int held = 0;
    };
    std::vector<lock> locks_;
};

/// Triangles of a mesh, once for each of some matrices, chunk by chunk.
template <class OnUse = on_use>
class snapped_mesh {
public:
    /// @param to_clip   one matrix per instance; those that are not finite draw nothing
    /// @throws std::invalid_argument  clip unset; an index out of range; a side of the image above guard_band
    template <class ParallelFor>
    snapped_mesh(glm::ivec2 size, const mesh_view& mesh, std::span<const glm::dmat4> to_clip, clip_space clip,
                 cull_mode cull, near_plane at_near, ParallelFor&& parallel, const char* function)
        : mesh_(mesh), size_(size), cull_(cull), at_near_(at_near), chunk_(mesh) {
        require_drawable(size, clip, function);
        if (mesh.triangles.empty()) return;
        const std::size_t count = mesh.triangles.size();
        indices_.resize((count + piece - 1) / piece);
        in_pieces(static_cast<int>(indices_.size()), parallel, [&](int first, int last) {
            for (std::size_t i = std::size_t(first); i < std::size_t(last); ++i)
                indices_[i] = indices_of(mesh.triangles, i * piece, lesser((i + 1) * piece, count));
        });
        const std::size_t highest = indices_from(0, count).highest;
        require(highest < mesh.positions.size(), function, "mesh.triangles", "indices of positions", highest);
        if (size.x == 0 || size.y == 0) return;
        instances_.reserve(to_clip.size());
        for (const glm::dmat4& matrix : to_clip)
            if (all_finite(matrix)) instances_.emplace_back(matrix, clip, size);
    }
    snapped_mesh(const snapped_mesh&) = delete;
    snapped_mesh& operator=(const snapped_mesh&) = delete;

    /// Calls use() for each chunk, to draw it.
    template <class ParallelFor, class Use>
    void for_each_chunk(ParallelFor&& parallel, const Use& use) {
        // As many vertices as a cache holds. More with threads, which are then started less often, and where pieces
        // share vertices with others, which would be snapped once per piece.
        const std::size_t step = is_serial<ParallelFor> && !shares_vertices() ? piece : several_pieces;
        for (std::size_t instance = 0; instance < instances_.size(); instance += chunk_.instances())
            for (std::size_t first = 0; first < mesh_.triangles.size(); first += step) {
                chunk_.take(first, {instances_.data() + instance, instances_.size() - instance}, step,
                            indices_from(first, step));
                chunk_.snap(parallel);
                use();
            }
    }

    /// Passes on the chunk in the mesh's order.
    /// @param draw   (const triangles&)
    template <class Draw>
    void for_each_batch(const Draw& draw) const {
        for_each_batch_of(0, chunk_.count(), draw);
    }

    /// Passes on the chunk in an order that keeps texels in the cache. No two threads draw to the same row at once.
    /// @param target   see depth_target of rasterize.hpp. Drawing a batch must not throw
    template <class ParallelFor, class Target>
    void for_each_batch(ParallelFor&& parallel, const Target& target) {
        const int rows = limited(band_texels / size_.x, 1, band_rows), bands = (size_.y + rows - 1) / rows;
        if (bands == 1 || is_coherent(rows)) {
            if constexpr (is_serial<ParallelFor>) return for_each_batch(target);
            else return for_each_batch_under_locks(parallel, target);
        }
        const auto draw_bands = [&](int first, int last) {
            Target own = target;
            for (int band = first; band < last; ++band) {
                const texel_bounds bounds{{0, band * rows}, {size_.x, lesser((band + 1) * rows, size_.y)}};
                own.in_band({bounds.first.y, bounds.last.y}, [&](const auto& draw) {
                    in_batches(bounds, draw, [&](const auto& add) {
                        lists_.for_each(band, [&](const auto& list) { add_from(list, add); });
                    });
                });
            }
        };
        const auto read = [&](unsigned i, const auto& put) { put_into_bands(i, rows, put); };
        lists_.begin(chunk_.count(), bands);
        while (lists_.fill(parallel, read)) parallel(bands, draw_bands);
    }

private:
    template <class ParallelFor>
    static constexpr bool is_serial = std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>;
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    using lists = band_lists<OnUse>;
    static constexpr unsigned piece = lists::piece;
    static constexpr std::size_t several_pieces = 16 * piece;
    static constexpr unsigned handful = 1 << 10;                  // triangles that a thread draws at a time
    static constexpr unsigned before = 1u << projection::z_near;  // bit of the near plane

    /// Vertex indices of `count` triangles from the first of a piece on, or of those that remain.
    [[nodiscard]] index_range indices_from(std::size_t first, std::size_t count) const {
        index_range all;
        for (std::size_t i = first / piece; i < indices_.size() && i * piece < first + count; ++i)
            all.include(indices_[i]);
        return all;
    }

    /// True if each piece alone touches more vertices than it has corners, but several pieces together do not.
    [[nodiscard]] bool shares_vertices() const {
        const index_range one = indices_from(0, piece), several = indices_from(0, several_pieces);
        return one.count() > 3 * piece && several.count() < 3 * lesser(several_pieces, mesh_.triangles.size());
    }

    /// Corners of a triangle, and the planes that any of them is outside of.
    struct corners {
        const snapped_vertex &a, &b, &c;
        unsigned crossed = planes_outside(a) | planes_outside(b) | planes_outside(c);
    };
    [[nodiscard]] UMBRAGE_INLINE corners corners_of(const drawn_triangle& at) const {
        return {chunk_.vertex(at, 0), chunk_.vertex(at, 1), chunk_.vertex(at, 2)};
    }

    /// True when triangles draw nothing if all their corners are outside of these planes. There may be no planes.
    [[nodiscard]] bool is_out_of_sight(unsigned planes) const {
        return at_near_ == near_plane::clips ? planes != 0 : (planes & ~before) != 0;
    }

    /// Drawn parts of a triangle that crosses planes: the part behind the near plane and, if that plane clamps, the
    /// part in front of it. There are none if the triangle is outside of another plane, or not finite.
    /// @param use   (a, b, c, unsigned triangle), for each triangle of a part
    template <class Use>
    void for_each_part(const drawn_triangle& at, const corners& c, const Use& use) const {
        const unsigned beyond = planes_outside(c.a) & planes_outside(c.b) & planes_outside(c.c);
        if (is_out_of_sight(beyond) || (c.crossed & projection::nowhere)) return;
        const auto h = [&](glm::length_t corner) { return chunk_.homogeneous(at, corner); };
        const auto part = [&](near_side side) {
            const auto [v, count] = clip_triangle(chunk_.projection_of(at), h(0), h(1), h(2), c.crossed, side);
            for (std::size_t k = 1; int(k) + 1 < count; ++k) use(v[0], v[k], v[k + 1], unsigned(at.triangle));
        };
        if (!beyond) part(near_side::behind);
        if (at_near_ == near_plane::clamps && (c.crossed & before)) part(near_side::before);
    }

    /// Draws in batches the triangles that for_each(add) adds by add(a, b, c, unsigned triangle).
    template <class Draw, class ForEach>
    void in_batches(const texel_bounds& bounds, const Draw& draw, const ForEach& for_each) const {
        triangles batch;
        const auto finish = [&] {
            batch.set_up(bounds, cull_);
            draw(batch);
            batch.count = 0;
        };
        for_each([&](const auto& a, const auto& b, const auto& c, unsigned triangle) UMBRAGE_INLINE {
            batch.add(a, b, c, triangle);
            if (batch.full()) finish();
        });
        if (batch.count > 0) finish();
    }

    template <class Draw>
    void for_each_batch_of(unsigned first, unsigned last, const Draw& draw) const {
        in_batches({{0, 0}, size_}, draw, [&](const auto& add) {
            for (unsigned i = first; i < last; ++i) {
                const drawn_triangle at = chunk_.place_of(i);
                const corners c = corners_of(at);
                if (c.crossed == 0) add(c.a, c.b, c.c, unsigned(at.triangle));
                else for_each_part(at, c, add);
            }
        });
    }

    /// Draws by threads under locks. Each thread draws triangles that follow each other. They cover few rows, so
    /// threads seldom wait for each other.
    template <class ParallelFor, class Draw>
    void for_each_batch_under_locks(ParallelFor&& parallel, const Draw& draw) const {
        row_locks<> locks(size_.y);
        parallel(static_cast<int>((chunk_.count() + handful - 1) / handful), [&](int first, int last) {
            for_each_batch_of(unsigned(first) * handful, lesser(unsigned(last) * handful, chunk_.count()),
                              [&](const triangles& batch) {
                                  const glm::ivec2 rows = batch.covered_rows();
                                  if (rows.x < rows.y) locks.hold(rows, [&] { draw(batch); });
                              });
        });
    }

    template <class Add>
    void add_from(const typename lists::list& list, const Add& add) const {
        for (std::size_t k = 0; k < list.whole.size(); ++k) {
            expect(list.whole, k);
            const drawn_triangle at = chunk_.place_of(list.whole[k]);
            const corners c = corners_of(at);
            add(c.a, c.b, c.c, unsigned(at.triangle));
        }
        for (const auto& part : list.parts) add(part.a, part.b, part.c, part.triangle);
    }

    /// True when successive triangles are in few bands, judged by samples.
    [[nodiscard]] bool is_coherent(int rows_a_band) const {
        constexpr unsigned looks = 16, many = 64;
        const unsigned step = greater(chunk_.count() / looks, many);
        int covered = 0, allowed = 0;
        for (unsigned first = 0; first < chunk_.count(); first += step, allowed += 2 * rows_a_band) {
            std::int32_t lowest = guard_band * subtexels, highest = -lowest;
            for (unsigned i = first; i < lesser(first + many, chunk_.count()); ++i) {
                const corners c = corners_of(chunk_.place_of(i));
                if (c.crossed != 0) continue;
                lowest = lesser(lowest, c.a.y, c.b.y, c.c.y), highest = greater(highest, c.a.y, c.b.y, c.c.y);
            }
            const glm::ivec2 rows = rows_between(lowest, highest);
            covered += greater(rows.y - rows.x, 0);
        }
        return covered <= allowed;
    }

    /// Rows first <= y < last that triangles may cover.
    [[nodiscard]] glm::ivec2 rows_between(std::int32_t lowest, std::int32_t highest) const {
        const auto between = triangles::rows_between(lowest, highest);
        return {greater(between.x, 0), lesser(between.y, size_.y)};
    }

    /// Calls put() with a triangle of the chunk, or its parts, and the bands in which they may be visible.
    template <class Put>
    void put_into_bands(unsigned i, int rows_a_band, const Put& put) const {
        const auto bands = [&](const auto& a, const auto& b, const auto& c) {
            const glm::ivec2 rows = rows_between(lesser(a.y, b.y, c.y), greater(a.y, b.y, c.y));
            return glm::ivec2(rows.x / rows_a_band, (greater(rows.y, 0) + rows_a_band - 1) / rows_a_band);
        };
        const drawn_triangle at = chunk_.place_of(i);
        const corners c = corners_of(at);
        if (c.crossed == 0) return put(bands(c.a, c.b, c.c), i);
        for_each_part(at, c, [&](const auto& p, const auto& q, const auto& r, unsigned triangle) {
            put(bands(p, q, r), typename lists::part{p, q, r, triangle});
        });
    }

    /// Prefetches the triangles after the k-th of a list, which can be anywhere. Inlined: see prefetch_line().
    UMBRAGE_INLINE void expect(const std::vector<unsigned>& list, std::size_t k) const {
        constexpr std::size_t soon = 16, later = 32;
        if (k + later < list.size())
            mesh_.triangles.stored_from(chunk_.place_of(list[k + later]).triangle,
                                        [](const auto* indices, std::size_t)
                                            UMBRAGE_INLINE { prefetch_line(indices); });
        if (k + soon >= list.size()) return;
        const drawn_triangle at = chunk_.place_of(list[k + soon]);
        for (glm::length_t corner = 0; corner < 3; ++corner) prefetch_line(&chunk_.vertex(at, corner));
    }

    mesh_view mesh_;
    glm::ivec2 size_;
    cull_mode cull_;
    near_plane at_near_;
    std::vector<projection> instances_;
    snapped_chunk<OnUse> chunk_;
    std::vector<index_range> indices_;  // per piece
    lists lists_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
