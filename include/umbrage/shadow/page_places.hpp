// SPDX-License-Identifier: MIT
//
// Place of a receiver in the pages of an adaptive shadow map, whose table lies in the uniform block.
//
// See also: adaptive_maps.hpp, the setup; page_coordinate, which reads a larger table from a texture.
#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Place of a point of the world in the page that holds it.
/// @param to_root         page_matrix: 1 to 2 across the root page
/// @param planes          plane_matrix in texels of the deepest level
/// @param cells           16 x 16 cells of the deepest level, row by row. A cell is slot + 64 (2^level - 1). Each
///                        number holds two cells: first + 1024 second
/// @param anchor          xyz: position that is subtracted from the point's
/// @param pages           x: size of a page, y: width of its gutter, texels
/// @param slack           of a plane: texels of slope x of the page and y of the deepest level; depth z, and w in the
///                        deepest level, which larger texels multiply
/// @param world           position of the point
/// @param normal          its normal
/// @return                its place, with weight 1. Outside the root page: one that every filter takes as lit
/// @exactness             C, n = 68: as receiver_slope, and a division. S of each
[[nodiscard]] UMBRAGE_INLINE inline std::array<map_place, 1> adaptive_maps_places(
    const glm::mat4& to_root, const glm::mat4& planes, const std::array<glm::mat4, 8>& cells, const glm::vec4& anchor,
    const glm::vec4& pages, const glm::vec4& slack, const shadow_terms&, glm::vec3 world, glm::vec3 normal) {
    constexpr int side = 16;
    const glm::vec3 way = world - glm::vec3(anchor);
    const glm::vec3 in_root(shadow_coordinate(to_root, way));
    const auto within = [](float v) { return !is_nan(v) && v >= 1.0f && v < 2.0f; };
    const bool inside = within(in_root.x) && within(in_root.y);
    const glm::vec2 coord = inside ? glm::vec2(in_root) : glm::vec2(1);
    const int i = static_cast<int>(coord.y * 16.0f - 16.0f) * side + static_cast<int>(coord.x * 16.0f - 16.0f);
    const auto cell = static_cast<glm::length_t>(i);
    const int two = static_cast<int>(cells[static_cast<std::size_t>(i / 32)][cell / 8 % 4][cell / 2 % 4]);
    const int code = i % 2 == 0 ? two % 1024 : two / 1024;
    const float across = static_cast<float>(code / 64 + 1);
    const glm::vec2 place = coord * across;
    const glm::vec2 at = inside ? (place - glm::floor(place)) * pages.x + pages.y : glm::vec2(32768);
    const float larger = 16.0f / across;  // than texels of the deepest level
    const glm::vec2 deepest = receiver_slope(planes, normal, way);
    const float steep = glm::abs(deepest.x) + glm::abs(deepest.y);
    const float off = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return {map_place{code % 64, glm::vec3(at, in_root.z), deepest * larger, 1.0f, off}};
}

namespace glsl {

inline constexpr snippet adaptive_maps_places{
    .name = "adaptive_maps_places",
    .summary = "place of a point of the world in the pages of an adaptive map",
    .exactness = tier::c,
    .operations = 68,
    .needs = list<&shadow_coordinate, &cascade_column_8, &receiver_slope>,
    .source = R"GLSL(
// umbrage_adaptive_maps_places: place of a point of the world in the page that holds it
//   to_root              matrix from the world to 1.0 to 2.0 across the root page
//   planes               plane matrix in texels of the deepest level
//   cells_0 to cells_7   16 x 16 cells of that level, row by row, two in each number: first + 1024.0 second; a cell is
//                        slot + 64.0 (2^level - 1.0)
//   anchor               position that is subtracted from world
//   pages                size of a page and width of its gutter, in texels
//   slack                of a plane: texels of slope of the page and of the deepest level; depth, and depth there
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
UMBRAGE_HIGHP mat4 umbrage_adaptive_maps_places(UMBRAGE_HIGHP mat4 to_root, UMBRAGE_HIGHP mat4 planes,
                                                UMBRAGE_HIGHP mat4 cells_0, UMBRAGE_HIGHP mat4 cells_1,
                                                UMBRAGE_HIGHP mat4 cells_2, UMBRAGE_HIGHP mat4 cells_3,
                                                UMBRAGE_HIGHP mat4 cells_4, UMBRAGE_HIGHP mat4 cells_5,
                                                UMBRAGE_HIGHP mat4 cells_6, UMBRAGE_HIGHP mat4 cells_7,
                                                UMBRAGE_HIGHP vec4 anchor, UMBRAGE_HIGHP vec4 pages,
                                                UMBRAGE_HIGHP vec4 slack, UMBRAGE_HIGHP vec4 terms,
                                                UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP vec4 none = vec4(0.0, 0.0, 0.0, 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(anchor.x, anchor.y, anchor.z);
    UMBRAGE_HIGHP vec4 in_root = umbrage_shadow_coordinate(to_root, way);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    UMBRAGE_HIGHP vec2 coord = inside ? vec2(in_root.x, in_root.y) : vec2(1.0, 1.0);
    UMBRAGE_HIGHP vec2 cell = floor(coord * 16.0 - 16.0);
    UMBRAGE_HIGHP float right = floor(cell.x * 0.125);
    UMBRAGE_HIGHP float column = cell.y * 2.0 + right;
    UMBRAGE_HIGHP vec4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    UMBRAGE_HIGHP vec4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    UMBRAGE_HIGHP vec4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    UMBRAGE_HIGHP vec4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    UMBRAGE_HIGHP vec4 low = column < 7.5 ? a : b;
    UMBRAGE_HIGHP vec4 high = column < 23.5 ? c : d;
    UMBRAGE_HIGHP vec4 eight = column < 15.5 ? low : high;
    UMBRAGE_HIGHP float along = cell.x - right * 8.0;
    UMBRAGE_HIGHP float pair = floor(along * 0.5);
    UMBRAGE_HIGHP float left_two = pair < 0.5 ? eight.x : eight.y;
    UMBRAGE_HIGHP float right_two = pair < 2.5 ? eight.z : eight.w;
    UMBRAGE_HIGHP float two = pair < 1.5 ? left_two : right_two;
    UMBRAGE_HIGHP float second = floor(two * (1.0 / 1024.0));
    UMBRAGE_HIGHP float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    UMBRAGE_HIGHP float before = floor(code * (1.0 / 64.0));
    UMBRAGE_HIGHP float across = before + 1.0;
    UMBRAGE_HIGHP vec2 place = coord * across;
    UMBRAGE_HIGHP vec2 within = (place - floor(place)) * pages.x + pages.y;
    UMBRAGE_HIGHP vec2 at = inside ? within : vec2(32768.0, 32768.0);
    UMBRAGE_HIGHP vec2 deepest = umbrage_receiver_slope(planes, normal, way);
    UMBRAGE_HIGHP float larger = 16.0 / across;
    UMBRAGE_HIGHP float steep = abs(deepest.x) + abs(deepest.y);
    UMBRAGE_HIGHP float off = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return mat4(vec4(at, in_root.z, code - before * 64.0),
                vec4(deepest * larger, 1.0, off), none, none);
}
)GLSL",
};

inline constexpr const snippet* page_places_snippets[]{&adaptive_maps_places};

}  // namespace glsl
}  // namespace umbrage
