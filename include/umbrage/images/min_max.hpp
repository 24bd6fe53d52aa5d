// SPDX-License-Identifier: MIT
//
// Min-max pyramid (Hi-Z) of a map: minimum and maximum depth of every square of 2 x 2, 4 x 4, ... texels.
//
//     const auto levels = umbrage::make_min_max_pyramid(map.view(), 3);
// minimum of the 4 x 4 texels around `texel`
// Also called: HiZ, min-max mip (make_min_max_pyramid).
//
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage {

/// One level: an element per square. Squares at the far borders are cut off by them.
struct depth_bounds {
    image<float> least;     ///< NaN where a texel is NaN
    image<float> greatest;  ///< over the texels that are numbers; NaN where none is
};

namespace detail {

/// Each element from 2 x 2, in blocks of 64. Beyond a border, values are repeated. The two images may be one.
template <class ParallelFor>
void halve(image_view<const float> least, image_view<const float> greatest, depth_bounds& to, ParallelFor&& parallel) {
    const glm::ivec2 size = to.least.size();
    parallel(size.y, [&](int first, int last) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            const bool both = least.data != greatest.data;
            alignas(64) std::int32_t keys[4][block];
            alignas(64) float ends[2][2 * block];
            for (int y = first; y < last; ++y)
                for (int x = 0; x < size.x; x += block) {
                    const int count = size.x - x < block ? size.x - x : block;
                    const auto load = [&](const image_view<const float>& from) UMBRAGE_INLINE {
                        const float* low = from.row(2 * y) + 2 * x;
                        const float* high = from.row(2 * y + 1 < from.size.y ? 2 * y + 1 : 2 * y) + 2 * x;
                        if (const int there = from.size.x - 2 * x; there < 2 * block) {
                            for (int i = 0; i < 2 * block; ++i) {
                                const int k = i < there ? i : there - 1;
                                ends[0][i] = low[k];
                                ends[1][i] = high[k];
                            }
                            low = ends[0];
                            high = ends[1];
                        }
                        for (int i = 0; i < block; ++i) {
                            keys[0][i] = order_key(low[2 * i]);
                            keys[1][i] = order_key(low[2 * i + 1]);
                            keys[2][i] = order_key(high[2 * i]);
                            keys[3][i] = order_key(high[2 * i + 1]);
                        }
                    };
                    const auto store = [&](auto pick, float* result) UMBRAGE_INLINE {
                        alignas(64) float depths[block];
                        for (int i = 0; i < block; ++i)
                            depths[i] =
                                from_order_key(pick(pick(keys[0][i], keys[1][i]), pick(keys[2][i], keys[3][i])));
                        copy_floats(result + x, depths, count);
                    };
                    load(least);
                    store(least_of{}, to.least.view().row(y));
                    if (both) load(greatest);
                    store(greatest_of{}, to.greatest.view().row(y));
                }
        });
    });
}

}  // namespace detail

/// Min-max pyramid of a map.
/// @param map       depths, any values
/// @param levels    number of levels: the first has squares of 2 x 2 texels, each next one of twice the side
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @return          the levels; a level of a single element is followed by others of a single element
/// @throws std::invalid_argument  empty map; negative levels
/// @exactness       A: selects, never computes
template <class ParallelFor = serial>
[[nodiscard]] std::vector<depth_bounds> make_min_max_pyramid(image_view<const float> map, int levels,
                                                             ParallelFor&& parallel = {}) {
    detail::require(!map.empty(), "make_min_max_pyramid", "map.size", "above 0", map.size);
    detail::require(levels >= 0, "make_min_max_pyramid", "levels", "0 or more", levels);
    std::vector<depth_bounds> pyramid;
    for (int level = 0; level < levels; ++level) {
        const image_view<const float> least = level ? pyramid.back().least.view() : map;
        const image_view<const float> greatest = level ? pyramid.back().greatest.view() : map;
        const glm::ivec2 size((least.size.x + 1) / 2, (least.size.y + 1) / 2);
        depth_bounds next{image<float>(size), image<float>(size)};
        detail::halve(least, greatest, next, parallel);
        pyramid.push_back(std::move(next));
    }
    return pyramid;
}

}  // namespace umbrage
