// SPDX-License-Identifier: MIT
//
// Page table of a virtual shadow map (adaptive shadow map): one fetch finds the atlas page that holds a receiver.
// The light sees the scene in a square, the root. The small table has one texel per finest cell of the root, and a
// border around them.
//
//     glm::vec3 p(umbrage::shadow_coordinate(to_root, world));  // x and y from 1 to 2 across the root
//     glm::vec4 at = umbrage::page_coordinate(umbrage::clamped(table), 1026.0f, glm::vec2(p), 128.0f, 4.0f);
//     const auto page = atlas.view().region(glm::ivec2(at.z, at.w), glm::ivec2(136));
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(page), glm::vec2(at), p.z - bias);
//
// A shader binds the filter to the atlas. Each page is a region of it:
//
//     glsl::source(glsl::version::v330, {glsl::page_coordinate,
//                                        bind(glsl::pcf_2x2, "page", {.texture = texture::atlas})});
//     // vec4 at = umbrage_page_coordinate(table, vec2(1026.0), p.xy, 128.0, 4.0);
//     // umbrage_pcf_2x2_page(atlas, at.zw, vec2(136.0), at.xy, p.z)
//
// Root coordinates go from 1 to 2, not from 0, so that all have 23 fraction bits. Adding a gutter to a position in a
// page then does not round.
// Also called: page table, indirection texture (page_coordinate). See also: pages.hpp, root.hpp.
#pragma once

#include <cstdint>

#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/core/unorm.hpp>

namespace umbrage {

/// Highest page level: the side of the root then holds 2^15 pages.
inline constexpr int deepest_page_level = 15;

/// Texel of a page table: RGBA8, read with the nearest filter.
///
/// Its last two bytes are the width of the root in pages of this level, low byte first. Shaders would have to compute
/// it from a level in steps. A power of two has one bit, so one byte is 0 and their sum does not round.
/// @param slot    slot of the page in the atlas, each 0 to 255
/// @param level   level of the page, 0 to 15: its side is the root's over 2^level
/// @return        entry of the page. All zero, which no page gives, means no page
[[nodiscard]] inline glm::u8vec4 page_entry(glm::ivec2 slot, int level) {
    const auto byte = [](int v) { return static_cast<std::uint8_t>(v & 0xFF); };
    const int across = 1 << (level & 15);  // a shift within the width for any level
    return {byte(slot.x), byte(slot.y), byte(across), byte(across >> 8)};
}

/// Position of a receiver in the page that holds it.
///
/// @param table    ivec2 -> page_entry, of size x size texels, the outermost all zero. Called once, with a texel inside
/// @param size     size of the table: the root's side in finest cells, a power of two up to 2^15, plus 2
/// @param coord    receiver position, 1 to 2 across the root
/// @param page     side of a page in texels, a power of two
/// @param gutter   border around each page in texels, an integer up to page / 2
/// @return         (x, y) in texels of the page with its gutter. The page is (page + 2 gutter)^2 texels of the atlas
///                 from texel (z, w) on
/// @edge           outside the root, or without a page: (32768, 32768, 0, 0), which every filter takes as lit.
///                 NaN or infinite coord: larger values than that, or NaN
/// @formula        origin = slot (page + 2 gutter); (coord 2^level - floor(coord 2^level)) page + gutter
/// @exactness      A
/// @cite           Fernando, Fernandez, Bala, Greenberg: Adaptive Shadow Maps, SIGGRAPH 2001
template <real T, class Table>
[[nodiscard]] glm::vec<4, T> page_coordinate(Table&& table, T size, glm::vec<2, T> coord, T page, T gutter) {
    const auto inside = [size](T v) { return is_nan(v) || !(v > T(0)) ? T(0) : (v < size ? v : size - T(1)); };
    const glm::vec<2, T> cell = coord * (size - T(2)) - (size - T(3));  // in texels of the table
    const glm::u8vec4 entry = table(glm::ivec2(static_cast<int>(inside(cell.x)), static_cast<int>(inside(cell.y))));
    const T across = T(entry.z) + T(entry.w) * T(256);
    const glm::vec<2, T> place = coord * across;
    const glm::vec<2, T> at = (place - glm::floor(place)) * page + (across > T(0) ? gutter : T(32768));
    return {at.x, at.y, T(entry.x) * (page + gutter * T(2)), T(entry.y) * (page + gutter * T(2))};
}

/// Pages a row of page_tile's atlas.
inline constexpr int page_tile_columns = 8;

/// First texel of a page in an atlas of eight a row, without a table of texels: see shadow/adaptive_maps.hpp.
/// @param number   number of the page's slot, an integer >= 0
/// @param size     size of a page with its gutter, texels. The atlas has sides below 2^31
/// @exactness      A
[[nodiscard]] inline glm::ivec2 page_tile(int number, int size) {
    return glm::ivec2(number % page_tile_columns, number / page_tile_columns) * size;
}

namespace glsl {

inline constexpr snippet page_coordinate{
    .name = "page_coordinate",
    .summary = "position of a receiver in the atlas page that holds it",
    .exactness = tier::a,
    .needs = list<&texel, &from_unorm>,
    .source = R"GLSL(
// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
UMBRAGE_HIGHP vec4 umbrage_page_coordinate(UMBRAGE_MAP table, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float page, UMBRAGE_HIGHP float gutter) {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    UMBRAGE_HIGHP vec2 sides = max(size - 2.0, vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 before = max(size - 3.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 cell = min(max(vec2(0.0, 0.0), coord * sides - before), size - 1.0);
    UMBRAGE_HIGHP ivec2 texel = ivec2(cell);  // the first texel for a NaN
    UMBRAGE_HIGHP vec4 entry = umbrage_from_unorm(umbrage_texel(table, size, vec2(texel)));
    UMBRAGE_HIGHP vec2 slot = vec2(entry.x, entry.y);
    UMBRAGE_HIGHP float across = entry.z + entry.w * 256.0;
    UMBRAGE_HIGHP vec2 within = clamp(fract(coord * across), vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return vec4(at, slot * (page + gutter * 2.0));
}
)GLSL",
};

inline constexpr snippet page_tile{
    .name = "page_tile",
    .summary = "first texel of a page in an atlas of eight a row",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
UMBRAGE_HIGHP vec2 umbrage_page_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = floor(number * 0.125);
    return vec2(number - row * 8.0, row) * size;
}
)GLSL",
};

inline constexpr const snippet* page_table_snippets[]{&page_coordinate, &page_tile};

}  // namespace glsl
}  // namespace umbrage
