// SPDX-License-Identifier: MIT
//
// Bilinear 2x2 percentage-closer filtering (PCF) over blocks of receivers.
#pragma once

#include <cstdint>

#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>

namespace umbrage::detail {

/// Bilinear filter with positions clamped to the centers of the map's border texels. These have the same neighbors, and
/// weights with the same sum. So both neighbors are in the map, and one load gets them.
template <depth_direction Direction, class Map>
struct pcf_2x2_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t offsets[block], compared[block];
        alignas(64) float hi_x[block], hi_y[block], z[block];
    };
    Map map;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map.map);
        constexpr int space = (1 << 15) + 1;  // a receiver inside may read the next texel
        const int last_x = last_in_space(map.map.size.x, space), last_y = last_in_space(map.map.size.y, space);
        const auto axis = [](float coord, int last, float& hi) UMBRAGE_INLINE {
            const std::int32_t position = floor_within(coord * 256.0f - 128.0f, static_cast<float>(last * 256));
            const std::int32_t here = position >> 8, last_pair = last - 1;
            const std::int32_t texel = here < last_pair ? here : last_pair;
            hi = static_cast<float>(position - texel * 256);
            return texel;
        };
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float x = receivers.x(i), y = receivers.y(i), z = receivers.z(i);
            at.compared[i] = test::compared(x, y, z);
            at.offsets[i] = memory.offset(axis(x, last_x, at.hi_x[i]), axis(y, last_y, at.hi_y[i]));
            at.z[i] = z;
        }
        prefetch(memory, at.offsets, 2);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        const texel_bytes memory(map.map);
        loaded_texels<Map> low(map), high(map);
        loaded_texels<Map>::load_two(memory, at.offsets, low, high);
        for (int i = 0; i < block; ++i) {
            const float z = low.receiver(at.z[i]), lo_x = 256.0f - at.hi_x[i], lo_y = 256.0f - at.hi_y[i];
            const auto weigh = [&](const auto& row) UMBRAGE_INLINE {
                return masked(lo_x, -test::lit(z, row.first(i))) + masked(at.hi_x[i], -test::lit(z, row.second(i)));
            };
            const float sum = lo_y * weigh(low) + at.hi_y[i] * weigh(high);
            visibility[i] = select(at.compared[i], sum * (1.0f / 65536.0f), 1.0f);
        }
    }
};

template <>
struct block_form<filters::pcf_2x2> : without_tables {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 2;
    template <depth_direction Direction, class Map>
    [[nodiscard]] static pcf_2x2_blocks<Direction, Map> blocks(const Map& map, const filters::pcf_2x2&, no_tables) {
        return {map};
    }
};

}  // namespace umbrage::detail
