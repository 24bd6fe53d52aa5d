// SPDX-License-Identifier: MIT
//
// Discs over blocks of receivers: the turned points of a row of pixels are looked up, not turned again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/simd/blocks/form.hpp>
#include <umbrage/simd/blocks/receivers.hpp>
#include <umbrage/simd/blocks/texels.hpp>

namespace umbrage::detail {

/// Taps of a disc in 1/256 texel from the receiver, for each row of 4 x 4 pixels' turns and each pixel of a block.
struct disc_table {
    struct tap {
        alignas(64) std::int32_t x[block], y[block];
    };
    std::vector<std::array<tap, 32>> of;

    disc_table(const disc_point* points, int count, float radius) : of(16) {
        const auto rho = static_cast<int>(disc_radius(radius));
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 4; ++x) {
                const glm::ivec2 turn(disc_turn(glm::vec2(static_cast<float>(x), static_cast<float>(y))));
                for (int p = 0; p < count; ++p) {
                    const disc_point point = points[p];
                    tap& taps = of[static_cast<std::size_t>(y)][static_cast<std::size_t>(p)];
                    for (int i = x; i < block; i += 4) {
                        taps.x[i] = (turn.x * point.x - turn.y * point.y) * rho >> 6;
                        taps.y[i] = (turn.y * point.x + turn.x * point.y) * rho >> 6;
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
        int row;  ///< of the table
    };
    image_view<const float> map;
    const disc_table& taps;
    int points, rows;  ///< of the map, before and behind a receiver's

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

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa set) const {
        out_of_line(set, [&](auto) UMBRAGE_INLINE { count_all(at, visibility); });
    }

private:
    UMBRAGE_INLINE void count_all(const placed& at, float* visibility) const {
        const float_texels of_map{map};
        const texel_bytes memory(map);
        const int last_x = map.size.x - 1, last_y = map.size.y - 1;
        loaded_texels<float_texels> texels(of_map);
        alignas(64) std::int32_t offsets[block], lit[block]{};
        for (int p = 0; p < points; ++p) {
            const disc_table::tap& tap = taps.of[static_cast<std::size_t>(at.row)][static_cast<std::size_t>(p)];
            for (int i = 0; i < block; ++i)
                offsets[i] = memory.offset(clamp_int((at.x[i] + tap.x[i]) >> 8, last_x),
                                           clamp_int((at.y[i] + tap.y[i]) >> 8, last_y));
            texels.load_one([&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); });
            for (int i = 0; i < block; ++i) lit[i] += test::lit(at.z[i], texels.one(i));
        }
        const float share = points == 8 ? 1.0f / 8.0f : (points == 16 ? 1.0f / 16.0f : 1.0f / 32.0f);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i)
            visibility[i] = select(at.compared[i], static_cast<float>(lit[i]) * share, 1.0f);
    }
};

template <>
struct block_form<filters::rotated_disc> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::rotated_disc& filter, ParallelFor&&,
                            const Use& use) {
        const disc_point* points = filter.points == 8    ? disc_points<8>.data()
                                   : filter.points == 16 ? disc_points<16>.data()
                                                         : disc_points<32>.data();
        const disc_table taps(points, filter.points, filter.radius_texels);
        use(disc_blocks<Direction>{map.map, taps, filter.points, static_cast<int>(filter.reach())});
    }
};

}  // namespace umbrage::detail
