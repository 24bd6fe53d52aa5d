// SPDX-License-Identifier: MIT
//
// Rasterizer for triangles of a few texels, a batch at a time. For each texel of their bounds, it loops over the
// triangles.
//
//     const small_triangles small(batch);
//     small.for_each_sample([&](int x, int y, float depth) { ... });
//     for (int i = 0; i < batch.count; ++i)
//         if (!small.has(i)) ...  // one by one
//
// One by one, such a triangle would take a register per edge and a loop over rows for two samples.
//
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <umbrage/core/config.hpp>
#include <umbrage/draw/raster/triangles.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

class small_triangles {
public:
    /// Finds them: bounds of a few texels on each side, depths that are normal numbers within (0, 1]. Takes none if
    /// they are too few to pay for the work on all triangles of the batch.
    /// @param batch   after set_up(). It must outlive this object
    UMBRAGE_INLINE explicit small_triangles(const triangles& batch) : batch_(batch) {
        using bits = std::int64_t;
        constexpr bits least_normal = bit_cast<bits>(0x1p-126), one = bit_cast<bits>(1.0);
        alignas(64) std::int32_t is_plain[block];
        for (int i = 0; i < block; ++i) {  // numbers above 0 have the order of their bits; others are below them
            const bits a = bit_cast<bits>(batch.corner_depth(0, i)), b = bit_cast<bits>(batch.corner_depth(1, i));
            const bits c = bit_cast<bits>(batch.corner_depth(2, i)), low = a < b ? a : b, high = a < b ? b : a;
            const bits lowest = low < c ? low : c, highest = high > c ? high : c;
            is_plain[i] = static_cast<std::int32_t>(-bits((lowest >= least_normal) & (highest <= one)));
            lowest_[i] = bit_cast<std::int32_t>(static_cast<float>(bit_cast<double>(lowest)));
            highest_[i] = bit_cast<std::int32_t>(static_cast<float>(bit_cast<double>(highest)));
        }
        std::int32_t count = 0, drawn = 0, most_columns = 0, most_rows = 0;
        const std::int32_t used = batch.count;
        for (int i = 0; i < block; ++i) {
            const std::int32_t columns = batch.columns[i], rows = batch.rows[i];
            const std::int32_t is_small =
                is_plain[i] & -(std::int32_t(i < used) & std::int32_t(rows > 0) & std::int32_t(rows <= side) &
                                std::int32_t(columns <= side) & std::int32_t(batch.is_small(i)));
            last_x_[i] = ((columns - 1) & is_small) | ~is_small;
            last_y_[i] = ((rows - 1) & is_small) | ~is_small;
            count -= is_small;
            drawn += std::int32_t(i < used) & std::int32_t(rows > 0);
            most_columns = greater(most_columns, columns & is_small);
            most_rows = greater(most_rows, rows & is_small);
        }
        if (count >= enough) columns_ = most_columns, rows_ = most_rows;
        has_all_ = drawn == (count >= enough ? count : 0);
    }

    /// True when the batch draws no other triangles.
    [[nodiscard]] UMBRAGE_INLINE bool has_all() const { return has_all_; }
    [[nodiscard]] UMBRAGE_INLINE bool has(int i) const { return columns_ > 0 && last_x_[i] >= 0; }

    /// Calls sample() for each texel that a small triangle covers.
    /// @param sample   (int x, int y, float depth): a covered texel, in any order
    template <class Sample>
    UMBRAGE_INLINE void for_each_sample(const Sample& sample) const {
        for (int y = 0; y < rows_; ++y)
            for (int x = 0; x < columns_; ++x) {
                std::uint64_t inside = inside_at(x, y);
                if (inside == 0) continue;
                alignas(64) float depths[block];
                find_depths(x, y, depths);
                for (; inside != 0; inside &= inside - 1) {
                    const int i = std::countr_zero(inside);
                    sample(batch_.first_x[i] + x, batch_.first_y[i] + y, depths[i]);
                }
            }
    }

private:
    static constexpr int side = 4;  // texels
    static constexpr int enough = block / 4;

    /// Triangles that cover the texel x to the right of their first one and y above it, one bit each.
    [[nodiscard]] UMBRAGE_INLINE std::uint64_t inside_at(int x, int y) const {
        alignas(64) std::uint32_t outside[block];  // in the sign
        for (int i = 0; i < block; ++i) {
            std::uint32_t sign = std::uint32_t(last_x_[i] - x) | std::uint32_t(last_y_[i] - y);
            for (int k = 0; k < 3; ++k)
                sign |= std::uint32_t(batch_.edge[k][i]) + std::uint32_t(x) * std::uint32_t(batch_.right[k][i]) +
                        std::uint32_t(y) * std::uint32_t(batch_.up[k][i]);
            outside[i] = sign;
        }
        static_assert(block == 64);
        std::uint32_t halves[2];
        for (std::size_t half = 0; half < 2; ++half) {
            std::uint32_t bits = 0;
            for (std::size_t i = 0; i < 32; ++i) bits |= ((outside[half * 32 + i] >> 31) - 1) & bit_of[i];
            halves[half] = bits;
        }
        return std::uint64_t(halves[1]) << 32 | halves[0];
    }

    /// Depths as of depth_plane, but rounded before they are limited, which gives the same.
    UMBRAGE_INLINE void find_depths(int x, int y, float (&depths)[block]) const {
        for (int i = 0; i < block; ++i) {
            std::int32_t depth = bit_cast<std::int32_t>(static_cast<float>(batch_.depth(i, x, y)));
            depth = depth < lowest_[i] ? lowest_[i] : depth;
            depths[i] = bit_cast<float>(depth > highest_[i] ? highest_[i] : depth);
        }
    }

    static constexpr std::array<std::uint32_t, 32> bit_of = [] {
        std::array<std::uint32_t, 32> bits{};
        for (std::size_t i = 0; i < 32; ++i) bits[i] = std::uint32_t(1) << i;
        return bits;
    }();

    const triangles& batch_;
    int columns_ = 0, rows_ = 0;  // largest of any triangle
    bool has_all_ = false;
    alignas(64) std::int32_t last_x_[block], last_y_[block];   // from the first texel; -1: not a small triangle
    alignas(64) std::int32_t lowest_[block], highest_[block];  // depths, as bits of floats
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
