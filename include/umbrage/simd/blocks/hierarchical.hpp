// SPDX-License-Identifier: MIT
//
// Filters over squares of texels for receivers most of which are wholly lit or wholly in shadow: those ask one number
// for the whole square. visibility() does it for filters::hierarchical_box and filters::hierarchical_window, which give
// bit for bit what filters::box and filters::window do.
//
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::hierarchical_box{8}, out);
//
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/blocks/box.hpp>
#include <umbrage/simd/blocks/window.hpp>

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

/// @tparam Blocks   of the filter that reads every texel of its box
template <class Blocks>
struct hierarchical_blocks {
    using test = typename Blocks::test;
    struct placed {
        receiver_block r;
        alignas(64) std::int32_t offsets[block], compared[block];
    };
    const box_bounds& tree;
    Blocks every_texel;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(tree.bounds.view());
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.last;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t compared = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = every_texel.first(masked(receivers.x(i), compared));
            const std::int32_t y = every_texel.first(masked(receivers.y(i), compared));
            at.r.set(i, receivers.x(i), receivers.y(i), receivers.z(i));
            at.offsets[i] =
                memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
            at.compared[i] = compared;
        }
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        const texel_bytes memory(tree.bounds.view());
        const receiver_block& r = at.r;
        alignas(64) std::int32_t open[block];
        alignas(64) glm::vec2 bounds[block];
        std::int32_t any = 0;
        gather<std::uint64_t>(gathered{bounds, [&](int i) UMBRAGE_INLINE { return memory.at(at.offsets[i]); }});
        for (int i = 0; i < block; ++i) {
            const std::int32_t lit = test::all_lit(r.z(i), bounds[i].x, bounds[i].y);
            const std::int32_t dark = test::none_lit(r.z(i), bounds[i].x, bounds[i].y);
            visibility[i] = select(-lit | ~at.compared[i], 1.0f, 0.0f);
            open[i] = at.compared[i] & ~-(lit | dark);
            any |= open[i];
        }
        if (any) out_of_line(set, [&](auto) UMBRAGE_INLINE { count_open(r, open, count, visibility, set); });
    }

private:
    /// Those that need the box.
    template <class Isa>
    UMBRAGE_INLINE void count_open(const receiver_block& r, const std::int32_t* open, int count, float* visibility,
                                   Isa set) const {
        receiver_block rest;
        alignas(64) float shares[block];
        int indices[block], found = 0;
        for (int i = 0; i < count; ++i) {
            indices[found] = i;
            rest.set(found, r.x(i), r.y(i), r.z(i));
            found -= open[i];
        }
        // Copies behind them: if all 64 boxes are in the map, none needs care.
        for (int i = found; i < block; ++i) rest.set(i, rest.xs[0], rest.ys[0], rest.zs[0]);
        typename Blocks::placed boxes;
        every_texel.place(rest, boxes);
        every_texel(boxes, found, shares, set);
        for (int i = 0; i < found; ++i) visibility[indices[i]] = shares[i];
    }
};

template <>
struct block_form<filters::hierarchical_box> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_box& filter, ParallelFor&& parallel,
                            const Use& use) {
        const box_blocks<Direction> every_texel{map.map, clamp_int(filter.radius, max_box_radius)};
        if (map.map.size.x < block) return use(every_texel);  // bounds come in whole blocks: they would outgrow the map
        const box_bounds tree(map.map, 2 * every_texel.radius + 1, parallel);
        use(hierarchical_blocks<box_blocks<Direction>>{tree, every_texel});
    }
};

template <>
struct block_form<filters::hierarchical_window> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_window& filter, ParallelFor&& parallel,
                            const Use& use) {
        const window_table weights(filter.row);
        const window_blocks<Direction> every_texel{map.map, filter.row, weights};
        if (map.map.size.x < block) return use(every_texel);
        const box_bounds tree(map.map, filter.row.touched(), parallel);
        use(hierarchical_blocks<window_blocks<Direction>>{tree, every_texel});
    }
};

}  // namespace umbrage::detail
