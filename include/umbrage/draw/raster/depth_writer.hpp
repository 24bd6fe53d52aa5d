// SPDX-License-Identifier: MIT
//
// Drawing of triangles into a depth image: the nearer of the stored depth and the plane's. All small triangles of a
// batch are drawn at once. The others are drawn one by one, in columns some texels wide.
//
//     draw<true>(rows, first, batch);
//
#pragma once

#include <cstddef>
#include <cstdint>

#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/raster/depth_rounding.hpp>
#include <umbrage/draw/raster/small_triangles.hpp>
#include <umbrage/draw/raster/triangles.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Writer of batches into rows of an image.
/// @tparam Lanes  texels side by side, two registers of doubles
template <bool Forward, int Lanes>
class depth_writer {
public:
    /// @param rows    rows of the image from the first on, upwards: all that the triangles cover
    UMBRAGE_INLINE depth_writer(image_view<float> rows, int first)
        : bottom_(reinterpret_cast<std::byte*>(rows.data)),
          up_(rows.stride),
          first_(first),
          width_(rows.size.x),
          skew_(static_cast<int>(reinterpret_cast<std::uintptr_t>(bottom_) / sizeof(float) % Lanes)) {}

    /// Draws the triangles of a batch.
    UMBRAGE_INLINE void draw(const triangles& batch) const {
        const small_triangles smaller(batch);
        for (int i = 0; i < batch.count; ++i)
            if (smaller.has(i)) expect(batch, i);
        smaller.for_each_sample([&](int x, int y, float depth) UMBRAGE_INLINE { take_nearer(depth, row(y)[x]); });
        if (smaller.has_all()) return;
        const triangles_of_binade of_binade(batch);
        for (int i = 0; i < batch.count; ++i) {
            if (i + 1 < batch.count) expect(batch, i + 1);
            if (!smaller.has(i)) draw(batch, i, of_binade.has(i));
        }
    }

private:
    using ints = lanes_of<std::int32_t, Lanes>;
    using floats = lanes_of<float, Lanes>;
    using doubles = lanes_of<double, Lanes / 2>;

    static constexpr int tile_columns = 64, tile_rows = 32, few_rows = 16;

    /// Prefetches the texels of a triangle. Their latency is about the time to draw another small one.
    UMBRAGE_INLINE void expect(const triangles& batch, int i) const {
        const int last = batch.first_y[i] + lesser(batch.rows[i], 16);
        for (int y = batch.first_y[i]; y < last; ++y) prefetch_line(row(y) + batch.first_x[i]);
    }

    UMBRAGE_INLINE void draw(const triangles& batch, int i, bool is_of_binade) const {
        if (batch.rows[i] == 0) return;
        const depth_plane plane = batch.plane(i);
        if (Forward ? plane.lowest > 1.0 : plane.highest < 0.0) return;
        if constexpr (has_lanes)  // depths of one sign, none flushed: they have the order of their bits
            if (width_ >= Lanes && plane.lowest >= 0x1p-126 && plane.highest <= 1.0) {
                if (is_of_binade) draw_columns(batch, i, plane, depths_of_binade<Lanes>(plane.lowest));
                else draw_columns(batch, i, plane, any_depths<Lanes>(plane.lowest, plane.highest));
                return;
            }
        draw_rows(batch, i, plane);
    }

    /// Keeps the nearer depth, but the stored one where it is NaN.
    /// @param depth   not NaN, not 0
    UMBRAGE_INLINE static void take_nearer(float depth, float& there) {
        if constexpr (finite_math_only)
            there = select(-(Forward ? is_lit(depth, there) : is_lit(there, depth)), depth, there);
        else there = (Forward ? depth < there : depth > there) ? depth : there;
    }

    /// Keeps the nearer depth per lane, but the stored one where it is NaN, or where `outside` is negative.
    /// @param depth   not NaN, not 0
    UMBRAGE_INLINE static void take_nearer(const floats& depth, const ints& outside, floats& there) {
        const ints bits = reinterpret_cast<ints>(depth), mask = outside >> 31;
        if constexpr (finite_math_only) {
            const ints old = reinterpret_cast<ints>(there);
            const ints kept = mask | ((old & 0x7FFFFFFF) > 0x7F800000) | (Forward ? depth > there : depth < there);
            there = reinterpret_cast<floats>((bits & ~kept) | (old & kept));
        } else {
            const auto seen = reinterpret_cast<floats>(bits | mask);  // or a NaN, which is not nearer
            there = (Forward ? seen < there : seen > there) ? seen : there;
        }
    }

    /// Draws a triangle texel by texel.
    void draw_rows(const triangles& batch, int i, const depth_plane& plane) const {
        batch.for_each_row(i, [&](int y, int first, int last) {
            float* const texels = row(y);
            for (int x = first; x < last; ++x) {
                const double z = plane(x, y);
                if (!(z >= 0.0 && z <= 1.0)) continue;
                const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
                if (!is_nan(texels[x]) && (Forward ? stored <= texels[x] : stored >= texels[x])) texels[x] = stored;
            }
        });
    }

    /// Draws a triangle column by column, in rows of a block each. Depths are normal numbers within (0, 1].
    /// @param depths   rounds the depths, see depth_rounding.hpp
    template <class Depths>
    UMBRAGE_INLINE void draw_columns(const triangles& batch, int i, const depth_plane& plane,
                                     const Depths& depths) const {
        // Columns begin where blocks do in memory. Two triangles then share full blocks, which the processor passes
        // from a store to the next load.
        const int first_x = batch.first_x[i], first_y = batch.first_y[i], rows = batch.rows[i];
        const int from = ((first_x + skew_) & -Lanes) - skew_, end = first_x + batch.columns[i];
        const std::int32_t right[] = {batch.right[0][i], batch.right[1][i], batch.right[2][i]};
        const std::int32_t up[] = {batch.up[0][i], batch.up[1][i], batch.up[2][i]};
        ints ramp;
        count_lanes<std::int32_t, Lanes>(ramp);
        doubles ramp_first, ramp_second;
        depths.count(ramp_first, ramp_second);

        // Texels x .. x_end - 1 of `height` rows; e: edges at x and y.
        const double dx = plane.dx, dy = plane.dy, corner = plane.z;
        const std::int32_t up0 = up[0], up1 = up[1], up2 = up[2];
        const std::ptrdiff_t stride = up_;
        const auto draw_tile = [&](int x, int y, int x_end, int height, const std::int32_t(&e)[3]) UMBRAGE_INLINE {
            ints e0 = right[0] * ramp + e[0], e1 = right[1] * ramp + e[1], e2 = right[2] * ramp + e[2];
            for (; x < x_end; x += Lanes, e0 += right[0] * Lanes, e1 += right[1] * Lanes, e2 += right[2] * Lanes) {
                int first = 0, last = height;
                if (height > few_rows) {
                    // Rows in which a texel of the column can be inside all edges, or one more on each side.
                    float low = 0.0f, high = static_cast<float>(height);
                    const std::int32_t start[] = {e0[0], e1[0], e2[0]};
                    for (int k = 0; k < 3; ++k) {
                        const std::int32_t best = start[k] + greater(0, right[k] * (Lanes - 1));
                        const float crossed = static_cast<float>(best) * batch.per_row[k][i];
                        low = up[k] > 0 && crossed > low ? crossed : low;
                        high = up[k] < 0 && crossed < high ? crossed : high;
                    }
                    first = static_cast<int>(low + 0.99f), last = lesser(static_cast<int>(high + 1.01f), height);
                    if (first >= last) continue;  // no step to a first row far beyond the tile
                }
                // A tile at the image's border is moved inside. Its other texels get the same bits again.
                const int within = lesser(greater(x, 0), width_ - Lanes), moved = within - x;
                ints f0 = e0, f1 = e1, f2 = e2;
                const double z = corner + dy * (y + first - first_y);
                if ((moved | first) != 0) {
                    f0 += right[0] * moved + up[0] * first;
                    f1 += right[1] * moved + up[1] * first;
                    f2 += right[2] * moved + up[2] * first;
                }
                doubles z_first = z + dx * (ramp_first + double(within - first_x));
                doubles z_second = z + dx * (ramp_second + double(within - first_x));
                std::byte* at = reinterpret_cast<std::byte*>(row(y + first) + within);
                for (int rest = last - first; rest > 0; --rest, at += stride) {
                    floats here, there;
                    depths.round(z_first, z_second, here);
                    load_lanes(at, there);
                    take_nearer(here, f0 | f1 | f2, there);
                    store_lanes(there, at);
                    f0 += up0, f1 += up1, f2 += up2;
                    z_first += dy, z_second += dy;
                }
            }
        };
        std::int32_t e[3];
        if (batch.is_small(i)) {
            for (int k = 0; k < 3; ++k) e[k] = batch.edge[k][i] + right[k] * (from - first_x);
            return draw_tile(from, first_y, end, rows, e);
        }
        for (int y = first_y; y < first_y + rows; y += tile_rows)
            for (int x = from; x < end; x += tile_columns) {
                for (int k = 0; k < 3; ++k) {  // as near to 0 as a tile's steps leave the sign
                    constexpr std::int64_t limit = 1 << 30;
                    e[k] = static_cast<std::int32_t>(limited(batch.edge_at(k, i, x, y), -limit, limit));
                }
                draw_tile(x, y, lesser(x + tile_columns, end), lesser(first_y + rows - y, tile_rows), e);
            }
    }

    [[nodiscard]] UMBRAGE_INLINE float* row(int y) const {
        return reinterpret_cast<float*>(bottom_ + (y - first_) * up_);
    }

    std::byte* bottom_;
    std::ptrdiff_t up_;
    int first_, width_, skew_;
};

template <bool Forward>
void draw(image_view<float> rows, int first, const triangles& batch) {
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr isa in_use = decltype(set)::value;
        constexpr int lanes = in_use == isa::base ? 4 : in_use == isa::avx2 ? 8 : 16;
        depth_writer<Forward, lanes>(rows, first).draw(batch);
    });
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
