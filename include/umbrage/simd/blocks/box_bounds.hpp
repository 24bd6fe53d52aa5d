// SPDX-License-Identifier: MIT
//
// Least and greatest depth under boxes of texels, one number each for every place of a box.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/image.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// For every place where a box may start, the bounds of the squares of texels that the box touches: at most `cells`
/// squares of 2^level texels in a row.
struct box_bounds {
    int level, cells;
    glm::ivec2 last;          ///< of the starts, which begin cells - 1 squares in front of the map
    image<glm::vec2> bounds;  ///< least and greatest; rows are filled up to whole blocks

    /// @param width   of the box
    template <class ParallelFor>
    box_bounds(image_view<const float> map, int width, ParallelFor&& parallel)
        : level(width < 9 ? 1 : 2), cells(((1 << level) + width - 2) / (1 << level) + 1) {
        const glm::ivec2 squares = (map.size + ((1 << level) - 1)) >> level;
        last = squares + (cells - 2);
        bounds = image<glm::vec2>({(last.x + block) / block * block, last.y + 1});
        image<std::int32_t> least({bounds.size().x, squares.y}), greatest(least.size());
        parallel(squares.y, [&](int from, int to) {
            const int blocks = (squares.x + block - 1) / block;
            const auto columns = static_cast<std::size_t>(blocks * block) << level;
            std::vector<std::int32_t> low(columns), high(columns),
                padded(static_cast<std::size_t>(bounds.size().x + cells));
            on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = from; y < to; ++y) {
                    bounds_of_columns(map, y << level, low, high);
                    along_row(low, squares.x, padded, least_of{}, least.view().row(y));
                    along_row(high, squares.x, padded, greatest_of{}, greatest.view().row(y));
                }
            });
        });
        parallel(bounds.size().y, [&](int from, int to) {
            const auto row = [&](const image<std::int32_t>& of, int y) {
                return of.view().row(clamp_int(y - (cells - 1), squares.y - 1));
            };
            on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = from; y < to; ++y)
                    for (int x = 0; x < bounds.size().x; x += block) {
                        alignas(64) std::int32_t lows[block], highs[block];
                        widen(least_of{}, lows, [&](int k) UMBRAGE_INLINE { return row(least, y + k) + x; });
                        widen(greatest_of{}, highs, [&](int k) UMBRAGE_INLINE { return row(greatest, y + k) + x; });
                        glm::vec2* out = bounds.view().row(y) + x;
                        for (int i = 0; i < block; ++i) out[i] = {from_order_key(lows[i]), from_order_key(highs[i])};
                    }
            });
        });
    }

private:
    /// Over 2^level rows; the last row and column are repeated.
    UMBRAGE_INLINE void bounds_of_columns(const image_view<const float>& map, int y, std::vector<std::int32_t>& low,
                                          std::vector<std::int32_t>& high) const {
        for (int x = 0; x < static_cast<int>(low.size()); x += block) {
            alignas(64) std::int32_t lows[block], highs[block], keys[block];
            for (int k = 0; k < 1 << level; ++k) {
                const float* depths = map.row(clamp_int(y + k, map.size.y - 1)) + x;
                alignas(64) float repeated[block];
                if (x + block > map.size.x) {
                    for (int i = 0; i < block; ++i) repeated[i] = depths[clamp_int(x + i, map.size.x - 1) - x];
                    depths = repeated;
                }
                for (int i = 0; i < block; ++i) {
                    keys[i] = order_key(depths[i]);
                    lows[i] = k ? least_of{}(lows[i], keys[i]) : keys[i];
                    highs[i] = k ? greatest_of{}(highs[i], keys[i]) : keys[i];
                }
            }
            std::memcpy(&low[std::size_t(x)], lows, sizeof lows);
            std::memcpy(&high[std::size_t(x)], highs, sizeof highs);
        }
    }

    /// to[x] = pick over the `cells` squares from x - (cells - 1) on, those at the border repeated.
    template <class Pick>
    UMBRAGE_INLINE void along_row(std::vector<std::int32_t>& columns, int squares, std::vector<std::int32_t>& padded,
                                  Pick pick, std::int32_t* to) const {
        auto count = static_cast<int>(columns.size());
        for (int halving = 0; halving < level; ++halving) {
            count /= 2;
            for (int x = 0; x < count; x += block) {
                alignas(64) std::int32_t halves[block];
                const std::int32_t* pairs = &columns[std::size_t(2 * x)];
                for (int i = 0; i < block; ++i) halves[i] = pick(pairs[2 * i], pairs[2 * i + 1]);
                std::memcpy(&columns[std::size_t(x)], halves, sizeof halves);
            }
        }
        const auto before = padded.begin() + (cells - 1);
        std::fill(padded.begin(), before, columns.front());
        std::copy_n(columns.begin(), squares, before);
        std::fill(before + squares, padded.end(), columns[std::size_t(squares - 1)]);
        for (int x = 0; x < bounds.size().x; x += block)
            widen(pick, to + x, [&](int k) UMBRAGE_INLINE { return padded.data() + k + x; });
    }

    /// to[i] = pick of from(k)[i] over k < cells, for a block.
    template <class Pick, class From>
    UMBRAGE_INLINE void widen(Pick pick, std::int32_t* to, const From& from) const {
        alignas(64) std::int32_t best[block];
        std::memcpy(best, from(0), sizeof best);
        for (int k = 1; k < cells; ++k) {
            const std::int32_t* other = from(k);
            for (int i = 0; i < block; ++i) best[i] = pick(best[i], other[i]);
        }
        std::memcpy(to, best, sizeof best);
    }
};

/// Of filters that are known by their reach alone: texels whose centres lie so far from a receiver, an axis, and how
/// many they can be.
struct reached_texels {
    int reach;  ///< in 1/256 texel
    explicit reached_texels(float texels) : reach(-floor_int(-texels * 256.0f)) {}

    [[nodiscard]] int count() const { return (2 * reach + 1) / 256 + 1; }
    /// What is added to floor(256 coord), so that a 256th of it is the first of them.
    [[nodiscard]] int before() const { return 127 - reach; }
};

}  // namespace umbrage::detail
