// SPDX-License-Identifier: MIT
//
// Tile of a map in an atlas of equal maps, row by row: where a shadow finds each of its light's maps.
//
//     glm::ivec2 origin = umbrage::map_tile(number, 3, map_size);  // a cube's six maps lie in three columns
//
#pragma once

#include <glm/vec2.hpp>

#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// First texel of a map in an atlas.
/// @param number    number of the map, an integer >= 0. Below 2^16 in a shader
/// @param columns   maps per row, >= 1. A shader takes their number and its reciprocal
/// @param size      size of a map, texels. The atlas has sides below 2^31
/// @exactness       A: integers; the quotient is half a step away from any
[[nodiscard]] inline glm::ivec2 map_tile(int number, int columns, glm::ivec2 size) {
    return glm::ivec2(number % columns, number / columns) * size;
}

namespace glsl {

inline constexpr snippet map_tile{
    .name = "map_tile",
    .summary = "first texel of a map in an atlas of equal maps",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
UMBRAGE_HIGHP vec2 umbrage_map_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 columns, UMBRAGE_HIGHP vec2 size) {
    UMBRAGE_HIGHP float row = floor((number + 0.5) * columns.y);
    return vec2(number - row * columns.x, row) * size;
}
)GLSL",
};

inline constexpr const snippet* map_tile_snippets[]{&map_tile};

}  // namespace glsl
}  // namespace umbrage
