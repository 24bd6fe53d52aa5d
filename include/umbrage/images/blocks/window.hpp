// SPDX-License-Identifier: MIT
//
// Sliding kernels over blocks of receivers, for any row of weights. A register holds a row of the kernel's texels. Each
// row adds its weight to the lanes that are lit, and the columns' weights are applied last.
#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>

#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/planes.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>
#include <umbrage/simd/lanes.hpp>

namespace umbrage::detail {

/// window_weights for every step that a kernel can have moved; 0 outside it.
struct window_table {
    alignas(64) float of[256][16]{};

    explicit window_table(const window_row& row) {
        for (int moved = 0; moved < 256; ++moved) window_weights(row, moved, of[moved]);
    }
};

template <depth_direction Direction>
struct window_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], offsets[block];  ///< first texel of the kernel
        alignas(64) std::int32_t moved_x[block], moved_y[block], inside[block], compared[block];
        alignas(64) float z[block];
        std::int32_t all_inside;  ///< all bits if registers can be loaded for every kernel
    };
    image_view<const float> map;
    const window_row& row;
    const window_table& weights;

    [[nodiscard]] UMBRAGE_INLINE int side() const { return row.touched(); }  ///< side of a kernel, texels
    [[nodiscard]] UMBRAGE_INLINE int loaded() const {                        ///< texels per row
        return row.touched() > 8 ? 16 : (row.touched() > 4 ? 8 : 4);
    }

    /// First of the texels that a receiver reads, along an axis.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t first(float coord) const {
        return ((floor_int(coord * 256.0f) - (row.size % 2 ? 128 : 0)) >> 8) - row.size / 2;
    }

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int before = row.size / 2, half = row.size % 2 ? 128 : 0;
        const int last_x = map.size.x - loaded(), last_y = map.size.y - row.touched();
        std::int32_t all = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t right = floor_int(masked(receivers.x(i), at.compared[i]) * 256.0f) - half;
            const std::int32_t up = floor_int(masked(receivers.y(i), at.compared[i]) * 256.0f) - half;
            const std::int32_t x = (right >> 8) - before, y = (up >> 8) - before;
            at.moved_x[i] = right & 255;
            at.moved_y[i] = up & 255;
            at.inside[i] = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            at.offsets[i] = memory.offset(x & at.inside[i], y & at.inside[i]);
            at.x[i] = x;
            at.y[i] = y;
            at.z[i] = receivers.z(i);
            all &= at.inside[i];
        }
        at.all_inside = all;
        prefetch(memory, at.offsets, last_y < 0 ? 1 : row.touched());
    }

    template <class Placed, class Isa>
    UMBRAGE_INLINE void operator()(const Placed& at, int count, float* visibility, Isa set) const {
        out_of_line(set,
                    [&](auto) UMBRAGE_INLINE { weigh_all<Isa::value == isa::base ? 4 : 8>(at, count, visibility); });
    }

private:
    template <int Lanes, class Placed>
    UMBRAGE_INLINE void weigh_all(const Placed& at, int count, float* visibility) const {
        alignas(64) float sums[block]{};
        if (map.size.x >= loaded() && map.size.y >= row.touched()) {
            if (Lanes == 8 && row.touched() == 4) weigh_inside<4, 1, 4>(at, count, sums);
            else if (row.touched() <= 4) weigh_inside<4, 1>(at, count, sums);
            else if (row.touched() <= 8) weigh_inside<Lanes, 8 / Lanes>(at, count, sums);
            else weigh_inside<Lanes, 16 / Lanes>(at, count, sums);
        }
        if (!at.all_inside)
            for (int i = 0; i < count; ++i)
                if (at.compared[i] & ~at.inside[i]) sums[i] = weigh_at_border(at, i);
        const float whole = row.whole * row.whole, scale = row.scale;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float sum = masked(sums[i], number_mask(at.z[i]));
            visibility[i] = select(~at.compared[i] | -std::int32_t(sum == whole), 1.0f, sum * scale);
        }
    }

    /// Weights four rows of four texels, two per register.
    template <class Placed>
    UMBRAGE_INLINE void weigh_four_rows(const Placed& at, int i, const std::byte* texels, std::ptrdiff_t stride,
                                        const float* rows, const float* columns, lanes_of<float, 4>& sum) const {
        const auto on_planes = rows_on_planes<4>(at, i, at.x[i], at.y[i], 4);
        lanes_of<float, 4> upper, lower, weights_of_rows;
        lanes_of<float, 8> two_rows, first, second;
        lanes_of<std::int32_t, 8> mask;
        const auto keep_lit = [&](int j, lanes_of<float, 8>& weight) UMBRAGE_INLINE {
            load_lanes(texels + j * stride, upper);
            load_lanes(texels + (j + 1) * stride, lower);
            on_planes.template compare<test::forward>(0, j, upper);
            on_planes.template compare<test::forward>(0, j + 1, lower);
            shuffle<0, 1, 2, 3, 4, 5, 6, 7>(upper, lower, two_rows);
            lit_lanes<8, test::forward>(at.z[i], two_rows, mask);
            keep_where<8>(mask, weight);
        };
        load_lanes(rows, weights_of_rows);
        shuffle<0, 0, 0, 0, 1, 1, 1, 1>(weights_of_rows, weights_of_rows, first);
        shuffle<2, 2, 2, 2, 3, 3, 3, 3>(weights_of_rows, weights_of_rows, second);
        keep_lit(0, first);
        keep_lit(2, second);
        first += second;
        shuffle<0, 1, 2, 3>(first, first, upper);
        shuffle<4, 5, 6, 7>(first, first, lower);
        load_lanes(columns, sum);
        sum = (upper + lower) * sum;
    }

    /// Weights texels for all receivers. A receiver outside the map uses the map's first texels.
    template <int Lanes, int Registers, int Rows = 0, class Placed>
    UMBRAGE_INLINE void weigh_inside(const Placed& at, int count, float* sums) const {
        const texel_bytes memory(map);
        const int touched = row.touched();
        const auto weigh = [&](int i, lanes_of<float, 4>& sum) UMBRAGE_INLINE {
            const float *rows = weights.of[at.moved_y[i]], *columns = weights.of[at.moved_x[i]];
            if constexpr (Rows == 4)
                return weigh_four_rows(at, i, memory.data + at.offsets[i], memory.stride, rows, columns, sum);
            sum = lanes_of<float, 4>{};
            const auto on_planes = rows_on_planes<Lanes>(at, i, at.x[i], at.y[i], touched);
#pragma GCC unroll 4
            for (int r = 0; r < Registers; ++r) {
                const std::byte* from = memory.data + at.offsets[i] + std::size_t(r) * Lanes * sizeof(float);
                lanes_of<float, Lanes> lit{}, texels;
                lanes_of<std::int32_t, Lanes> mask;
                for (int j = 0; j < touched; ++j) {
                    load_lanes(from, texels);
                    on_planes.template compare<test::forward>(r * Lanes, j, texels);
                    lit_lanes<Lanes, test::forward>(at.z[i], texels, mask);
                    add_where<Lanes>(mask, rows[j], lit);
                    from += memory.stride;
                }
                load_lanes(columns + r * Lanes, texels);
                add_products<Lanes>(lit, texels, sum);
            }
        };
        for (int i = 0; i < count; i += 4) {  // a block is a multiple of four
            lanes_of<float, 4> a, b, c, d, four;
            weigh(i, a);
            weigh(i + 1, b);
            weigh(i + 2, c);
            weigh(i + 3, d);
            sum_four_lanes(a, b, c, d, four);
            store_lanes(four, sums + i);
        }
    }

    template <class Placed>
    [[nodiscard]] float weigh_at_border(const Placed& at, int i) const {
        const float *columns = weights.of[at.moved_x[i]], *rows = weights.of[at.moved_y[i]];
        float sum = 0.0f;
        for (int j = 0; j < row.touched(); ++j) {
            const float* texels = texel_at(map, 0, clamp_int(at.y[i] + j, map.size.y - 1));
            for (int k = 0; k < row.touched(); ++k) {
                const float stored = texels[clamp_int(at.x[i] + k, map.size.x - 1)];
                if (test::lit(at.z[i], texel_on_plane<test::forward>(at, i, stored, at.x[i] + k, at.y[i] + j)))
                    sum += rows[j] * columns[k];
            }
        }
        return sum;
    }
};

template <>
struct every_texel_form<filters::window> : plain_form {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <class ParallelFor>
    [[nodiscard]] static window_table tables(const float_texels&, const filters::window& filter, ParallelFor&&) {
        return window_table(filter.row);
    }
    template <depth_direction Direction>
    [[nodiscard]] static window_blocks<Direction> blocks(const float_texels& map, const filters::window& filter,
                                                         const window_table& weights) {
        return {map.map, filter.row, weights};
    }
};

}  // namespace umbrage::detail
