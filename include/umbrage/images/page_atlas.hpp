// SPDX-License-Identifier: MIT
//
// Virtual shadow map pages (adaptive shadow map) over images: depth pass into an atlas, page table, and visibility of
// receivers.
//
//     umbrage::image<float> atlas(umbrage::page_atlas_size(cache, size), umbrage::cleared_depth(clip));
//     umbrage::draw_pages(atlas, size, root, cache.update(receivers).drawn, [&](auto map, const glm::mat4& to_clip) {
//         umbrage::rasterize_depth(map, tree, umbrage::instances_in_map(box, trees, to_clip, clip), to_clip, clip);
//     });
//     umbrage::image<glm::u8vec4> table(umbrage::page_table_size(cache));
//     umbrage::write_page_table(cache, table);
//     umbrage::visibility({atlas, table, size}, umbrage::depth32f{}, seen, umbrage::filters::pcf_2x2{}, out);
//
// Also called: shadow atlas, virtual texture of a shadow map (draw_pages).
//
#pragma once

#include <algorithm>
#include <span>

#include <glm/fwd.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>

namespace umbrage {

namespace detail {

/// Checks that an atlas of 256 pages of this size a side has a size.
inline void require_page_size(const page_size& size, const char* function) {
    require(size.texels >= 1 && size.texels <= 16384, function, "size.texels", "from 1 to 16384", size.texels);
    require(size.gutter >= 0 && size.gutter <= 8192, function, "size.gutter", "from 0 to 8192", size.gutter);
}

}  // namespace detail

/// Size in texels of an atlas with a slot for every page that a cache may hold.
/// @throws std::invalid_argument  texels or gutter out of range
[[nodiscard]] inline glm::ivec2 page_atlas_size(const page_cache& cache, const page_size& size) {
    detail::require_page_size(size, "page_atlas_size");
    return cache.budget().slots * size.pitch();
}

/// Size in texels of a table: one for each of a cache's finest cells, and one around them.
[[nodiscard]] inline glm::ivec2 page_table_size(const page_cache& cache) {
    return glm::ivec2((1 << cache.budget().deepest_level) + 2);
}

/// Clears pages and draws them.
///
/// @param atlas   depths, of page_atlas_size
/// @param size    size of a page, with its gutter
/// @param root    light of the root, in double, so that a page's matrix rounds only once
/// @param pages   from page_cache::update
/// @param draw    depth pass under root.clip: (image_view<float> map, const glm::mat4& world_to_clip). Called once per
///                page, with its gutter
/// @throws std::invalid_argument  a slot outside the atlas, and the errors of page_light
template <class Draw>
void draw_pages(image_view<float> atlas, const page_size& size, const light_space<double>& root,
                std::span<const placed_page> pages, Draw&& draw) {
    for (const auto& [page, slot] : pages) {
        const light_space<double> light = page_light(root, page, size);
        detail::require(slot.x >= 0 && slot.y >= 0 && slot.x < 256 && slot.y < 256, "draw_pages", "slot",
                        "from 0 to 255 each", slot);
        const image_view<float> map = atlas.region(slot * size.pitch(), glm::ivec2(size.pitch()));
        for (int y = 0; y < map.size.y; ++y) std::fill_n(map.row(y), map.size.x, cleared_depth(root.clip));
        draw(map, glm::mat4(light.projection * light.view));
    }
}

/// Writes the finest page of each cell to a table.
/// @param cache   cache with the pages that are drawn
/// @param table   image of page_table_size. Receives a page_entry for each of the cache's finest cells; row 1 is the
///                root's first. Cells without a page, and cells around the root, are zero
/// @throws std::invalid_argument  a table of another size
inline void write_page_table(const page_cache& cache, image_view<glm::u8vec4> table) {
    detail::require_size(table.size, page_table_size(cache), "write_page_table", "table.size", "page_table_size");
    for (int y = 0; y < table.size.y; ++y) std::fill_n(table.row(y), table.size.x, glm::u8vec4(0));
    cache.for_each([&](const page& p, glm::ivec2 slot) {
        const int cells = (table.size.x - 2) >> p.level;
        for (int y = p.y * cells; y < (p.y + 1) * cells; ++y)
            std::fill_n(table.row(1 + y) + 1 + p.x * cells, cells, page_entry(slot, p.level));
    });
}

/// Atlas and table in which a receiver's page is found.
template <class Texel>
struct page_map {
    image_view<const Texel> atlas;
    image_view<const glm::u8vec4> table;  ///< page_entry texels; its side is a power of two plus 2
    page_size size{};
};

namespace detail {

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_pages(const page_map<typename Encoding::texel>& map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    constexpr auto function = "visibility";
    const int side = map.table.size.x;
    require_size(out.size, size_of(receivers, function), function, "out.size", "the receivers' size");
    require(side >= 3 && map.table.size.y == side && ((side - 2) & (side - 3)) == 0, function, "table.size",
            "square, a power of two and 2 a side", map.table.size);
    require_filter(function, filter);
    require_page_size(map.size, function);
    const int pitch = map.size.pitch();
    if constexpr (requires { filter.reach(); }) require_reach(function, "size.gutter", map.size.gutter, filter.reach());
    for (int y = 0; y < side; ++y)
        for (const glm::u8vec4& entry : std::span(map.table.row(y), static_cast<std::size_t>(side)))
            require(glm::all(glm::lessThanEqual((glm::ivec2(entry) + 1) * pitch, map.atlas.size)), function, "table",
                    "of slots that the atlas has", glm::ivec2(entry));
    const auto table = [&](glm::ivec2 cell) { return map.table[cell]; };
    const auto page = static_cast<float>(map.size.texels), gutter = static_cast<float>(map.size.gutter);
    const auto& directed = in_direction(filter, direction_of(encoding, filter));
    const auto alone = [&](glm::vec2 coord, float depth, glm::ivec2 pixel) {
        const glm::vec4 at = page_coordinate(table, static_cast<float>(side), coord, page, gutter);
        const auto texels = map.atlas.region(glm::ivec2(at.z, at.w), glm::ivec2(pitch));
        return filtered(directed, decoded(clamped(texels), encoding), glm::vec2(at), depth, pixel);
    };
    parallel(out.size.y, [&](int first, int last) { filter_each(receivers, out, first, last, alone); });
}

}  // namespace detail

/// Visibility from virtual shadow map pages.
/// @param map         atlas, table and page size, as for draw_pages and write_page_table
/// @param encoding    encoding of the atlas' texels, with the depth direction. Its edge decides ties
/// @param receivers   (x, y) from 1 to 2 across the root, z depth with the bias already applied
/// @param filter      as for visibility of a single map. It does not read beyond a page and its gutter
/// @param out         receives visibility, 1 lit; same size as receivers, other memory than these and the atlas
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @edge              receiver without a page, or outside the root: lit
/// @throws std::invalid_argument  sizes differ; table sides are not a power of two plus 2; a slot is outside the
///                                atlas; texels or gutter out of range, or the gutter below the filter's reach; a
///                                filter's number out of range
/// @exactness         the bits of the filter alone over each receiver's page
template <class Encoding, receiver_image Receivers = receiver_planes, class Filter, class ParallelFor = serial>
void visibility(const page_map<typename Encoding::texel>& map, const Encoding& encoding, const Receivers& receivers,
                const Filter& filter, image_view<float> out, ParallelFor&& parallel = {}) {
    detail::filter_pages(map, encoding, detail::viewed(receivers), filter, out, parallel);
}

}  // namespace umbrage
