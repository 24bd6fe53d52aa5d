// SPDX-License-Identifier: MIT
//
// Minimum and maximum depth under boxes of texels, one number each for every position of a box.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// Bounds of depth for every start of a box. The box touches at most `cells` squares of 2^level texels in a row.
struct box_bounds {
    int level, cells;
    glm::ivec2 squares;             ///< number of squares in the map
    glm::ivec2 last;                ///< last start; starts begin cells - 1 squares before the map
    unset_image<glm::vec2> bounds;  ///< minimum and maximum; rows are padded to full blocks

    /// @param width   width of the box, texels
    template <class ParallelFor>
    box_bounds(image_view<const float> map, int width, ParallelFor&& parallel)
        : level(width < 9 ? 1 : 2),
          cells(((1 << level) + width - 2) / (1 << level) + 1),
          squares((map.size + ((1 << level) - 1)) >> level),
          last(squares + (cells - 2)),
          bounds({(last.x + block) / block * block, last.y + 1}) {
        parallel(bounds.view.size.y, [&](int from, int to) {
            const int before = cells - 1, columns = bounds.view.size.x;
            const int plane = columns + (before + block) / block * block;
            const auto row_size = static_cast<std::size_t>(2 * plane);
            std::vector<std::int32_t> row(row_size + static_cast<std::size_t>(before));
            std::vector<std::int32_t> rows(row_size *
                                           static_cast<std::size_t>(cells));  // rows of squares, the latest ones
            const auto row_at = [&](int y) UMBRAGE_INLINE { return rows.data() + (y + before) % cells * 2 * plane; };
            on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = from - before; y < to; ++y) {
                    std::int32_t* const planes[]{row.data(), row.data() + plane};
                    bounds_of_squares(map, clamp_int(y, squares.y - 1), planes);
                    for (int x = 0; x < 2 * plane; x += block)
                        widen(row_at(y) + x, [&](int k) UMBRAGE_INLINE { return row.data() + x + k; });
                    if (y < from) continue;
                    for (int x = 0; x < columns; x += block) {
                        alignas(64) std::int32_t low[block], high[block];
                        widen(low, [&](int k) UMBRAGE_INLINE { return row_at(y - k) + x; });
                        widen(high, [&](int k) UMBRAGE_INLINE { return row_at(y - k) + plane + x; });
                        glm::vec2* out = bounds.view.row(y) + x;
                        for (int i = 0; i < block; ++i) out[i] = {from_order_key(low[i]), from_order_key(~high[i])};
                    }
                }
            });
        });
    }

private:
    static constexpr int deepest = 2;  ///< largest level

    /// Bounds of a row of squares: minima, and maxima as complements so that both are minima. Squares at the border are
    /// repeated as far as boxes can start or end.
    UMBRAGE_INLINE void bounds_of_squares(const image_view<const float>& map, int y,
                                          std::int32_t* const planes[2]) const {
        for (int x = 0; x < squares.x; x += block) {
            alignas(64) std::int32_t parts[2][block << deepest];
            for (int i = 0; i < block << level; i += block)
                bounds_of_columns(map, {(x << level) + i, y << level}, parts[0] + i, parts[1] + i);
            for (int p = 0; p < 2; ++p) {
                for (int left = block << level; left > block; left /= 2)
                    for (int i = 0; i < left; i += 2 * block) halve(parts[p] + i, parts[p] + i / 2);
                std::memcpy(planes[p] + cells - 1 + x, parts[p], sizeof(std::int32_t) * block);
            }
        }
        for (int p = 0; p < 2; ++p) {
            std::int32_t* const row = planes[p];
            const int first = cells - 1, end = first + squares.x;
            for (int x = 0; x < first; ++x) row[x] = row[first];
            for (int x = end; x < first + bounds.view.size.x; ++x) row[x] = row[end - 1];
        }
    }

    /// Bounds of columns over 2^level rows. The last row and column are repeated.
    UMBRAGE_INLINE void bounds_of_columns(const image_view<const float>& map, glm::ivec2 first, std::int32_t* low,
                                          std::int32_t* high) const {
        constexpr int rows = 1 << deepest;
        alignas(64) float repeated[rows][block];
        const float* depths[rows];
        for (int k = 0; k < rows; ++k) {
            const float* row = map.row(clamp_int(first.y + (k & ((1 << level) - 1)), map.size.y - 1));
            depths[k] = row + first.x;
            prefetch_bytes(depths[k], map.stride * (1 << level), block * sizeof(float));
            if (first.x + block <= map.size.x) continue;
            for (int i = 0; i < block; ++i) repeated[k][i] = row[clamp_int(first.x + i, map.size.x - 1)];
            depths[k] = repeated[k];
        }
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t a = order_key(depths[0][i]), b = order_key(depths[1][i]);
            const std::int32_t c = order_key(depths[2][i]), d = order_key(depths[3][i]);
            low[i] = least(least(a, b), least(c, d));
            high[i] = ~greatest(greatest(a, b), greatest(c, d));
        }
    }

    static UMBRAGE_INLINE void halve(const std::int32_t* pairs, std::int32_t* to) {
        alignas(64) std::int32_t halves[block];
        for (int i = 0; i < block; ++i) halves[i] = least(pairs[2 * i], pairs[2 * i + 1]);
        std::memcpy(to, halves, sizeof halves);
    }

    /// to[i] = smallest of from(k)[i] over k < cells, for a block.
    template <class From>
    UMBRAGE_INLINE void widen(std::int32_t* to, const From& from) const {
        alignas(64) std::int32_t best[block];
        std::memcpy(best, from(0), sizeof best);
        for (int k = 1; k < cells; ++k) {
            const std::int32_t* other = from(k);
            for (int i = 0; i < block; ++i) best[i] = least(best[i], other[i]);
        }
        std::memcpy(to, best, sizeof best);
    }

    static UMBRAGE_INLINE std::int32_t least(std::int32_t a, std::int32_t b) { return least_of{}(a, b); }
    static UMBRAGE_INLINE std::int32_t greatest(std::int32_t a, std::int32_t b) { return greatest_of{}(a, b); }
};

/// Texels within a filter radius of a receiver along an axis: the first one, and their largest number. It is for
/// filters of which only the radius is known.
struct reached_texels {
    int reach;  ///< filter radius in 1/256 texel
    explicit reached_texels(float texels) : reach(-floor_int(-texels * 256.0f)) {}

    [[nodiscard]] int count() const { return (2 * reach + 1) / 256 + 1; }
    /// Number to add to floor(256 coord), so that 1/256 of the sum is the index of the first texel.
    [[nodiscard]] int before() const { return 127 - reach; }
};

}  // namespace umbrage::detail
