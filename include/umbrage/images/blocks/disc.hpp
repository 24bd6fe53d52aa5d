// SPDX-License-Identifier: MIT
//
// Disc filter over blocks of receivers. Rotated points of a row of pixels come from a table. All texels near a
// receiver are compared at once, one row per register, where that is less work than point after point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/planes.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>
#include <umbrage/simd/lanes.hpp>

namespace umbrage::detail {

/// Taps of a disc in 1/256 texel from the receiver. There is one for each row of the 4 x 4 rotation pattern and each
/// pixel of a block.
struct disc_table {
    struct tap {
        alignas(64) std::int32_t x[block], y[block];
        alignas(64) std::uint32_t packed[block];
    };
    std::vector<std::array<tap, 32>> of;
    int farthest = 0;  ///< largest distance along an axis

    /// Both coordinates in one word, for sums from 0 to 2047. x is at the top, where its borrows and carries are lost.
    static UMBRAGE_INLINE std::uint32_t pack(std::int32_t x, std::int32_t y) {
        return (static_cast<std::uint32_t>(x) << 21) + static_cast<std::uint32_t>(y);
    }

    template <class = on_use>
    disc_table(const disc_point* points, int count, float radius) : of(16) {
        const auto rho = static_cast<int>(disc_radius(radius));
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 4; ++x) {
                const glm::ivec4 rotation(disc_rotation(glm::vec2(static_cast<float>(x), static_cast<float>(y))));
                for (int p = 0; p < count; ++p) {
                    const disc_point point = points[p];
                    tap& taps = of[static_cast<std::size_t>(y)][static_cast<std::size_t>(p)];
                    const int right = (rotation.x * point.x + rotation.y * point.y) * rho >> 6;
                    const int up = (rotation.z * point.x + rotation.w * point.y) * rho >> 6;
                    for (const int way : {right, -right, up, -up}) farthest = way > farthest ? way : farthest;
                    for (int i = x; i < block; i += 4) {
                        taps.x[i] = right;
                        taps.y[i] = up;
                        taps.packed[i] = pack(right, up);
                    }
                }
            }
    }
};

template <depth_direction Direction>
struct disc_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], compared[block];  ///< in 1/256 texel
        alignas(64) float z[block];
        int row;  ///< row of the table
    };
    image_view<const float> map;
    const disc_table& taps;
    int points, rows;  ///< rows of the map before and after the receiver's

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        const texel_bytes memory(map);
        const int last_x = map.size.x - 1, last_y = map.size.y - 1 - rows;
        alignas(64) std::int32_t offsets[block];
        locate(receivers, at, pixel_y);
        for (int i = 0; i < block; ++i)
            offsets[i] = memory.offset(clamp_int(at.x[i] >> 8, last_x), clamp_int((at.y[i] >> 8) - rows, last_y));
        prefetch(memory, offsets, 2 * rows);
    }
    template <class Receivers>
    UMBRAGE_INLINE void locate(const Receivers& receivers, placed& at, int pixel_y) const {
        at.row = pixel_y & 15;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            at.x[i] = floor_int(masked(receivers.x(i), at.compared[i]) * 256.0f);
            at.y[i] = floor_int(masked(receivers.y(i), at.compared[i]) * 256.0f);
            at.z[i] = receivers.z(i);
        }
    }

    template <class Placed, class Isa>
    UMBRAGE_INLINE void operator()(const Placed& at, int, float* visibility, Isa set) const {
        if constexpr (Isa::value != isa::base) {
            near_texels texels;
            if (points >= 2 * near_rows && find_near(at, texels))
                return out_of_line(set, [&](auto) UMBRAGE_INLINE {
                    count_near<Isa::value == isa::avx512 ? 16 : 8>(at, texels, visibility);
                });
        }
        out_of_line(set, [&](auto) UMBRAGE_INLINE { count_all(at, visibility); });
    }

private:
    static constexpr int near_before = 3, near_rows = 7, near_columns = 8;
    struct near_texels {
        alignas(64) std::int32_t offsets[block];                           ///< offset of the first texel
        alignas(64) std::uint32_t from[block];                             ///< from that texel to the receiver, packed
        alignas(64) std::uint32_t upper[block], lower[block], lit[block];  ///< bits of four rows each
    };

    /// Finds the texels near each receiver that may be compared at once.
    /// @return   true when all points fall on these texels, and all of the texels are in the map
    UMBRAGE_INLINE bool find_near(const placed& at, near_texels& texels) const {
        const texel_bytes memory(map);
        const int last_x = map.size.x - near_columns, last_y = map.size.y - near_rows;
        if (last_x < 0 || last_y < 0 || taps.farthest > near_before * 256) return false;
        std::int32_t all = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (at.x[i] >> 8) - near_before, y = (at.y[i] >> 8) - near_before;
            const std::int32_t inside = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            texels.offsets[i] = memory.offset(x & inside, y & inside);
            texels.from[i] = disc_table::pack((at.x[i] & 255) + near_before * 256, (at.y[i] & 255) + near_before * 256);
            all &= inside | ~at.compared[i];
        }
        return all != 0;
    }

    template <int Lanes, class Placed>
    UMBRAGE_INLINE void count_near(const Placed& at, near_texels& texels, float* visibility) const {
        for (int i = 0; i < block; ++i) compare_near(at, i, texels.offsets[i], texels.upper[i], texels.lower[i]);
        const auto& row = taps.of[static_cast<std::size_t>(at.row)];
        for (int i = 0; i < block; i += Lanes) {
            lanes_of<std::uint32_t, Lanes> from, upper, lower, tap, lit{};
            load_lanes(texels.from + i, from);
            load_lanes(texels.upper + i, upper);
            load_lanes(texels.lower + i, lower);
            // Bit 4 y + x of columns 0 to 3, and of 4 to 7. There are seven rows, so none is lost.
            const auto left = (upper & 0xFFFF) | lower << 16;
            const auto right = (upper >> 16 | (lower & 0xFFFF0000)) << 4;
            for (int p = 0; p < points; ++p) {
                load_lanes(row[static_cast<std::size_t>(p)].packed + i, tap);
                tap += from;
                const auto on_right = reinterpret_cast<lanes_of<std::int32_t, Lanes>>(tap) < 0;
                lit += (on_right ? right : left) >> ((tap >> 6 & 28) + (tap >> 29)) & 1;
            }
            store_lanes(lit, texels.lit + i);
        }
        take_share(at, texels.lit, visibility);
    }

    /// Lit texels, as mask_bits of rows 0 to 3 and of rows 4 to 6.
    template <class Placed>
    UMBRAGE_INLINE void compare_near(const Placed& at, int i, std::int32_t offset, std::uint32_t& upper,
                                     std::uint32_t& lower) const {
        const texel_bytes memory(map);
        const auto on_planes =
            rows_on_planes<near_columns>(at, i, (at.x[i] >> 8) - near_before, (at.y[i] >> 8) - near_before, near_rows);
        const std::byte* from = memory.data + offset;
        lanes_of<std::int32_t, near_columns> lit[8]{};
        lanes_of<float, near_columns> texels;
#pragma GCC unroll 7
        for (int y = 0; y < near_rows; ++y, from += memory.stride) {
            load_lanes(from, texels);
            on_planes.template compare<test::forward>(0, y, texels);
            lit_lanes<near_columns, test::forward>(at.z[i], texels, lit[y]);
        }
        upper = mask_bits(lit);
        lower = mask_bits(lit + 4);
    }

    template <class Placed>
    UMBRAGE_INLINE void count_all(const Placed& at, float* visibility) const {
        const float_texels of_map{map};
        const texel_bytes memory(map);
        const int last_x = map.size.x - 1, last_y = map.size.y - 1;
        loaded_texels<float_texels> texels(of_map);
        alignas(64) std::int32_t offsets[block];
        alignas(64) std::uint32_t lit[block]{};
        for (int p = 0; p < points; ++p) {
            const disc_table::tap& tap = taps.of[static_cast<std::size_t>(at.row)][static_cast<std::size_t>(p)];
            for (int i = 0; i < block; ++i)
                offsets[i] = memory.offset(clamp_int((at.x[i] + tap.x[i]) >> 8, last_x),
                                           clamp_int((at.y[i] + tap.y[i]) >> 8, last_y));
            texels.load_one(memory, offsets);
            texels_on_planes<test::forward>(
                at, [&](int i) UMBRAGE_INLINE { return (at.x[i] + tap.x[i]) >> 8; },
                [&](int i) UMBRAGE_INLINE { return (at.y[i] + tap.y[i]) >> 8; }, texels.depths);
            for (int i = 0; i < block; ++i) lit[i] += static_cast<std::uint32_t>(test::lit(at.z[i], texels.one(i)));
        }
        take_share(at, lit, visibility);
    }

    UMBRAGE_INLINE void take_share(const placed& at, const std::uint32_t* lit, float* visibility) const {
        const float share = points == 8 ? 1.0f / 8.0f : (points == 16 ? 1.0f / 16.0f : 1.0f / 32.0f);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t count = static_cast<std::int32_t>(lit[i]) & number_mask(at.z[i]);
            visibility[i] = select(at.compared[i], static_cast<float>(count) * share, 1.0f);
        }
    }
};

template <>
struct every_texel_form<filters::disc> : plain_form {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <class ParallelFor>
    [[nodiscard]] static disc_table tables(const float_texels&, const filters::disc& filter, ParallelFor&&) {
        return {points_of_disc(filter.points).data(), filter.points, filter.radius_texels};
    }
    template <depth_direction Direction>
    [[nodiscard]] static disc_blocks<Direction> blocks(const float_texels& map, const filters::disc& filter,
                                                       const disc_table& taps) {
        return {map.map, taps, filter.points, static_cast<int>(filter.reach())};
    }
};

}  // namespace umbrage::detail
