// SPDX-License-Identifier: MIT
//
// Copy of the part of a map that some receivers read. Rows of a map that are a multiple of 2048 bytes apart share their
// places in the first-level cache, which has few of each. Tall boxes then evict their own rows. In a tile they do not.
//
//
//     map_tile tile;
//     if (map_tile::helps(map.stride, width) && map_tile::holds(first, last)) tile.copy(map, first, last);
//
#pragma once

#include <cstddef>
#include <cstring>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/images/blocks/texels.hpp>

namespace umbrage::detail {

struct map_tile {
    static constexpr int columns = 100, rows = 96;
    float texels[rows][columns];

    [[nodiscard]] static bool helps(std::ptrdiff_t stride, int width) { return width > 8 && stride % 2048 == 0; }
    [[nodiscard]] static bool holds(glm::ivec2 first, glm::ivec2 last) {
        return last.x - first.x < columns && last.y - first.y < rows;
    }

    /// Copies texels of the map.
    /// @param first         first texel of the map that the tile must hold
    /// @param last          last texel, at least seven columns farther
    UMBRAGE_INLINE void copy(const image_view<const float>& map, glm::ivec2 first, glm::ivec2 last) {
        const int count = last.x - first.x + 1;
        const auto eight = [](const float* from, float* to)
                               UMBRAGE_INLINE { std::memcpy(to, from, 8 * sizeof(float)); };
        for (int y = first.y; y <= last.y; ++y) {
            const float* from = texel_at(map, first.x, y);
            float* to = texels[y - first.y];
            for (int i = 0; i + 8 < count; i += 8) eight(from + i, to + i);
            eight(from + count - 8, to + count - 8);
        }
    }
};

}  // namespace umbrage::detail
