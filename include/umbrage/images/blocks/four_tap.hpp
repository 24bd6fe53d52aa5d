// SPDX-License-Identifier: MIT
//
// Four-tap filter over blocks of receivers.
#pragma once

#include <cstddef>
#include <cstdint>

#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/images/blocks/hard.hpp>

namespace umbrage::detail {

template <depth_direction Direction, class Map>
struct four_tap_blocks {
    using test = block_test<Direction>;
    struct placed {
        receiver_block r;
        placed_tap taps[4];
        alignas(64) std::int32_t compared[block];
    };
    static constexpr int space = 1 << 17;  // for the sum of the four taps
    Map map;
    std::array<glm::vec2, 4> offsets;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        for (std::size_t tap = 0; tap < 4; ++tap) at.taps[tap].place(map.map, at.r, offsets[tap], space);
        for (int i = 0; i < block; ++i) {
            std::int32_t x = 0, y = 0;
            for (const glm::vec2& offset : offsets) {
                x += floor_magnitude(at.r.x(i) + offset.x, float(space));
                y += floor_magnitude(at.r.y(i) + offset.y, float(space));
            }
            at.compared[i] = x < space && y < space ? ~beyond_far_plane_mask<test::forward>(at.r.z(i)) : 0;
        }
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        for (const placed_tap& tap : at.taps) tap.template count<test>(map, at.r.zs, lit);
        for (int i = 0; i < block; ++i)
            visibility[i] = static_cast<float>((lit[i] & at.compared[i]) | (4 & ~at.compared[i])) * 0.25f;
    }
};

template <>
struct block_form<filters::four_tap> : without_tables {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 1;
    template <depth_direction Direction, class Map>
    [[nodiscard]] static four_tap_blocks<Direction, Map> blocks(const Map& map, const filters::four_tap& filter,
                                                                no_tables) {
        return {map, filter.offsets};
    }
};

}  // namespace umbrage::detail
