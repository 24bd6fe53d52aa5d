// SPDX-License-Identifier: MIT
//
// Box filter over float maps, in blocks of receivers. It loads whole rows of a box at once, not texel by texel.
//
//     const box_rows<depth_direction::forward, 8, 0> rows(map.stride, 5);
//     std::int32_t lit = rows.count(row, 0, receiver);
//
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <glm/vec2.hpp>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/map_tile.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>
#include <umbrage/simd/lanes.hpp>

namespace umbrage::detail {

/// Count of lit texels in boxes inside a map that is at least as wide as a register.
/// @tparam Lanes   lanes of a register
/// @tparam Whole   full registers per row of the box
/// @tparam Width   width of the box, 0 if not known at compile time
template <depth_direction Direction, int Lanes, int Whole, int Width = 0>
struct box_rows {
    using ints = lanes_of<std::int32_t, Lanes>;
    static constexpr int reach = (Whole + 1) * Lanes;  ///< texels that are loaded per row
    std::ptrdiff_t stride;
    int width;
    std::int32_t
        window[3 * std::size_t(Lanes)]{};  ///< lanes of the last register that belong to the row, slid into place

    UMBRAGE_INLINE box_rows(std::ptrdiff_t bytes, int box_width) : stride(bytes), width(Width ? Width : box_width) {
        for (int i = 0; i < width - Whole * Lanes; ++i) window[Lanes + i] = -1;
    }

    /// Number of lit texels in one box.
    /// @param row     first texel of the box
    /// @param moved   texels by which the last register of a row is moved back, so that it ends inside the map
    [[nodiscard]] UMBRAGE_INLINE std::int32_t count(const std::byte* row, std::ptrdiff_t moved, float receiver) const {
        ints lit;
        std::int32_t sums[2];
        count_lanes(row, moved, receiver, lit);
        sum_two_lanes<Lanes>(lit, lit, sums);
        return sums[0];
    }

    /// Counts of two boxes, at less cost than one by one.
    UMBRAGE_INLINE void count_two(const std::byte* const rows[2], const float* receivers, std::int32_t* counts) const {
        ints first, second;
        count_lanes(rows[0], 0, receivers[0], first);
        count_lanes(rows[1], 0, receivers[1], second);
        sum_two_lanes<Lanes>(first, second, counts);
    }

private:
    UMBRAGE_INLINE void count_lanes(const std::byte* row, std::ptrdiff_t moved, float receiver, ints& lit) const {
        lit = ints{};
        ints rest{};
        const auto add_row = [&]() UMBRAGE_INLINE {
            const float* texels = reinterpret_cast<const float*>(row);
            lanes_of<float, Lanes> stored;
            ints lanes;
            for (int i = 0; i < Whole; ++i) {
                load_lanes(texels + i * Lanes, stored);
                lit_lanes<Lanes, block_test<Direction>::forward>(receiver, stored, lanes);
                lit -= lanes;
            }
            load_lanes(texels + Whole * Lanes - moved, stored);
            lit_lanes<Lanes, block_test<Direction>::forward>(receiver, stored, lanes);
            rest -= lanes;
            row += stride;
        };
        if constexpr (Width > 0) {
#pragma GCC unroll 8
            for (int j = 0; j < Width; ++j) add_row();
        } else
            for (int j = 0; j < width; ++j) add_row();
        ints wanted;
        std::memcpy(&wanted, window + Lanes - moved, sizeof wanted);
        lit += rest & wanted;
    }
};

/// Box filter on a float map. Other maps are decoded first, at less cost than decoding each texel for each box.
template <depth_direction Direction>
struct box_blocks {
    using test = block_test<Direction>;
    template <int Lanes, int Whole, int Width = 0>
    using rows = box_rows<Direction, Lanes, Whole, Width>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], offsets[block];  ///< first texel of the box
        alignas(64) std::int32_t inside[block], compared[block];
        alignas(64) float z[block];
        std::int32_t
            all_plain;  ///< all bits if all boxes and the texels loaded with them are inside, and no depth is NaN
    };
    image_view<const float> map;
    int radius;  ///< 0 .. max_box_radius

    /// First of the texels that a receiver reads, along an axis.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t first(float coord) const { return floor_int(coord) - radius; }
    [[nodiscard]] UMBRAGE_INLINE int side() const { return 2 * radius + 1; }  ///< side of a box, texels
    [[nodiscard]] UMBRAGE_INLINE int loaded() const { return side() + 7; }    ///< texels per row, in registers of eight

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int before = radius, last_x = map.size.x - side(), last_y = map.size.y - side();
        const int last_load = map.size.x - loaded();
        std::int32_t plain = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = floor_int(masked(receivers.x(i), at.compared[i])) - before;
            const std::int32_t y = floor_int(masked(receivers.y(i), at.compared[i])) - before;
            at.inside[i] = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            at.offsets[i] = memory.offset(x & at.inside[i], y & at.inside[i]);
            at.x[i] = x;
            at.y[i] = y;
            at.z[i] = receivers.z(i);
            const std::int32_t magnitude = detail::bit_cast<std::int32_t>(receivers.z(i)) & 0x7FFFFFFF;
            const auto loads_inside = std::int32_t(x <= last_load), number = std::int32_t(magnitude <= 0x7F800000);
            plain &= at.inside[i] & at.compared[i] & -(loads_inside & number);
        }
        at.all_plain = plain;
        prefetch(memory, at.offsets, last_y < 0 ? 1 : side());
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        out_of_line(set,
                    [&](auto) UMBRAGE_INLINE { count_all<Isa::value == isa::base ? 4 : 8>(at, count, visibility); });
    }

private:
    template <int Lanes>
    UMBRAGE_INLINE void count_all(const placed& at, int count, float* visibility) const {
        const int width = side();
        if constexpr (Lanes == 8) {
            if (width == 3) return count_with<rows<8, 0, 3>>(at, count, visibility);
            if (width == 5) return count_with<rows<8, 0, 5>>(at, count, visibility);
            if (width == 7) return count_with<rows<8, 0, 7>>(at, count, visibility);
        }
        if (width / Lanes == 0) return count_with<rows<Lanes, 0>>(at, count, visibility);
        if (width / Lanes == 1) return count_with<rows<Lanes, 1>>(at, count, visibility);
        if (width / Lanes == 2) return count_with<rows<Lanes, 2>>(at, count, visibility);
        if constexpr (Lanes == 4) {
            if (width / Lanes == 3) return count_with<rows<4, 3>>(at, count, visibility);
            count_with<rows<4, 4>>(at, count, visibility);
        }
    }

    template <class Boxes>
    UMBRAGE_INLINE void count_with(const placed& at, int count, float* visibility) const {
        const int width = side(), last_load = map.size.x - Boxes::reach;
        const Boxes boxes(map.stride, width);
        const texel_bytes memory(map);
        alignas(64) std::int32_t lit[block]{};
        if (at.all_plain)  // nearly always
            count_inside(boxes, at, count, lit);
        else
            for (int i = 0; i < count; ++i) {
                if (is_nan(at.z[i]) || !at.compared[i]) continue;
                const int moved = at.x[i] > last_load ? at.x[i] - last_load : 0;
                lit[i] = at.inside[i] && last_load >= 0 ? boxes.count(memory.data + at.offsets[i], moved, at.z[i])
                                                        : count_at_border<Boxes>({at.x[i], at.y[i]}, width, at.z[i]);
            }
        const float scale = box_scale<float>(radius);
        for (int i = 0; i < block; ++i)
            visibility[i] = select(-std::int32_t(lit[i] == width * width) | ~at.compared[i], 1.0f,
                                   static_cast<float>(lit[i]) * scale);
    }

    /// Counts for 64 boxes that are inside the map, with the texels loaded beside them.
    template <class Boxes>
    UMBRAGE_INLINE void count_inside(const Boxes& boxes, const placed& at, int count, std::int32_t* lit) const {
        const auto count_all = [&](const Boxes& of, const auto& row) UMBRAGE_INLINE {
            for (int i = 0; i < count; i += 2) {  // a block is even
                const std::byte* const starts[]{row(i), row(i + 1)};
                of.count_two(starts, at.z + i, lit + i);
            }
        };
        if (map_tile::helps(map.stride, side())) {
            glm::ivec2 first(at.x[0], at.y[0]), last = first;
            for (int i = 0; i < block; ++i) {
                first.x = at.x[i] < first.x ? at.x[i] : first.x;
                first.y = at.y[i] < first.y ? at.y[i] : first.y;
                last.x = at.x[i] > last.x ? at.x[i] : last.x;
                last.y = at.y[i] > last.y ? at.y[i] : last.y;
            }
            last += glm::ivec2(Boxes::reach - 1, 2 * radius);
            if (map_tile::holds(first, last)) {
                map_tile tile;
                tile.copy(map, first, last);
                return count_all(Boxes(sizeof tile.texels[0], side()), [&](int i) UMBRAGE_INLINE {
                    return reinterpret_cast<const std::byte*>(&tile.texels[at.y[i] - first.y][at.x[i] - first.x]);
                });
            }
        }
        const texel_bytes memory(map);
        count_all(boxes, [&](int i) UMBRAGE_INLINE { return memory.data + at.offsets[i]; });
    }

    /// Count from a copy of the box, with the map's border texels repeated.
    template <class Boxes>
    std::int32_t count_at_border(glm::ivec2 first, int width, float receiver) const {
        constexpr int widest = 2 * max_box_radius + 1;
        float texels[widest][Boxes::reach > widest ? Boxes::reach : widest]{};
        for (int j = 0; j < width; ++j) {
            const float* row = texel_at(map, 0, clamp_int(first.y + j, map.size.y - 1));
            for (int i = 0; i < width; ++i) texels[j][i] = row[clamp_int(first.x + i, map.size.x - 1)];
        }
        return Boxes(sizeof texels[0], width).count(reinterpret_cast<const std::byte*>(texels), 0, receiver);
    }
};

template <>
struct every_texel_form<filters::box> : without_tables {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction>
    [[nodiscard]] static box_blocks<Direction> blocks(const float_texels& map, const filters::box& filter, no_tables) {
        return {map.map, clamp_int(filter.radius, max_box_radius)};
    }
};

}  // namespace umbrage::detail
