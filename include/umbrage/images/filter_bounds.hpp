// SPDX-License-Identifier: MIT
//
// Bounds of the texels that a filter may read, by which `bounds_lit` returns early. Make them once per map. They have a
// fourth of the map's texels, or a sixteenth for filters with a large radius.
//
//     const auto [bounds, place] = umbrage::make_filter_bounds(map.view(), filter.reach());
//     float lit = umbrage::bounds_lit(umbrage::clamped(bounds), coord, depth - bias, place);
//     if (lit < 0) lit = filter(umbrage::bordered(map), coord, depth - bias);
//
// Also called: shadow mask of tiles, bounds of a kernel.
//
#pragma once

#include <algorithm>
#include <utility>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/images/blocks/box_bounds.hpp>

namespace umbrage {

/// Bounds of the depths that a filter may read, texel by texel.
struct filter_bounds {
    image<glm::vec2> bounds;  ///< smallest and largest depth; x is NaN where a texel is, y where all are
    glm::vec2 place;          ///< for bounds_lit
};

/// Bounds of a map's texels for a filter.
/// @param map        depths, any values
/// @param reach      filter radius in texels (filter.reach()), 0 .. 256
/// @param direction  depth direction of the map
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @param outside    value of texels outside the map, the same as for the filter
/// @throws std::invalid_argument  empty map; reach out of range
/// @exactness       A: selects, never computes
template <class ParallelFor = serial>
[[nodiscard]] filter_bounds make_filter_bounds(image_view<const float> map, float reach,
                                               depth_direction direction = depth_direction::forward,
                                               ParallelFor&& parallel = {},
                                               outside_map outside = outside_map::bordered) {
    detail::require(!map.empty(), "make_filter_bounds", "map.size", "above 0", map.size);
    detail::require(reach >= 0.0f && reach <= 256.0f, "make_filter_bounds", "reach", "from 0 to 256 texels", reach);
    image<float> ringed;
    const bool border = outside == outside_map::bordered;
    if (border) {
        ringed = image<float>(map.size + 2, cleared_depth(direction));
        for (int y = 0; y < map.size.y; ++y) std::copy_n(map.row(y), map.size.x, ringed.view().row(y + 1) + 1);
        map = ringed.view();
    }
    const detail::reached_texels reached(reach);
    detail::box_bounds tree(map, reached.count(), parallel);
    const int steps = 256 << tree.level;
    image<glm::vec2> bounds(tree.last + 1);
    for (int y = 0; y <= tree.last.y; ++y) std::copy_n(tree.bounds.view.row(y), bounds.size().x, bounds.view().row(y));
    const int first = reached.before() + (tree.cells - 1) * steps + (border ? 256 : 0);
    return {std::move(bounds), {static_cast<float>(first), 1.0f / static_cast<float>(steps)}};
}

}  // namespace umbrage
