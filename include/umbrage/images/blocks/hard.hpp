// SPDX-License-Identifier: MIT
//
// Hard shadow test over blocks of receivers, and the tap that it shares with other filters.
#pragma once

#include <cstdint>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/images/blocks/form.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/blocks/texels.hpp>

namespace umbrage::detail {

/// Taps on the receivers' own texels, clamped to the map: floor(coord + offset), as in four_tap. The result differs
/// from floor(coord) + offset where the sum rounds up to an integer. Filters over neighbors move the texel instead.
struct placed_tap {
    alignas(64) std::int32_t offsets[block];

    /// Finds each receiver's texel, and prefetches it.
    /// @param space   texels that a receiver can read, in each direction
    template <class T>
    UMBRAGE_INLINE void place(const image_view<T>& map, const receiver_block& receivers, glm::vec2 offset, int space) {
        const texel_bytes memory(map);
        const auto last_x = static_cast<float>(last_in_space(map.size.x, space)),
                   last_y = static_cast<float>(last_in_space(map.size.y, space));
        for (int i = 0; i < block; ++i)
            offsets[i] = memory.offset(floor_within(receivers.x(i) + offset.x, last_x),
                                       floor_within(receivers.y(i) + offset.y, last_y));
        prefetch(memory, offsets, 1);
    }

    /// Adds 1 for each receiver that is lit.
    template <class Test, class Map>
    UMBRAGE_INLINE void count(const Map& map, const float* z, std::int32_t* lit) const {
        const texel_bytes memory(map.map);
        loaded_texels<Map> texels(map);
        texels.load_one(memory, offsets);
        for (int i = 0; i < block; ++i) lit[i] += Test::lit(texels.receiver(z[i]), texels.one(i));
    }
};

template <depth_direction Direction, class Map>
struct hard_blocks {
    using test = block_test<Direction>;
    struct placed {
        receiver_block r;
        placed_tap tap;
        alignas(64) std::int32_t compared[block];
    };
    Map map;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        at.tap.place(map.map, at.r, glm::vec2(0.0f), 1 << 15);
        for (int i = 0; i < block; ++i) at.compared[i] = test::compared(at.r.x(i), at.r.y(i), at.r.z(i));
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        at.tap.template count<test>(map, at.r.zs, lit);
        for (int i = 0; i < block; ++i)
            visibility[i] = static_cast<float>((lit[i] & at.compared[i]) | (1 & ~at.compared[i]));
    }
};

template <>
struct block_form<filters::hard> : without_tables {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 1;
    template <depth_direction Direction, class Map>
    [[nodiscard]] static hard_blocks<Direction, Map> blocks(const Map& map, const filters::hard&, no_tables) {
        return {map};
    }
};

}  // namespace umbrage::detail
