// SPDX-License-Identifier: MIT
//
// Adaptive shadow map (virtual shadow map) with up to 64 pages, each of them a map. The uniform block holds the table
// that finds a receiver's page, so the deepest level is 4. `page_coordinate` reads a table of more pages and levels
// from a texture.
//
//     umbrage::page_cache cache({.slots = {8, 8}, .deepest_level = 4});
//     const auto drawn = cache.update(seen).drawn;          // each frame; see light/adaptive/README.md
//     const umbrage::page_size size{.texels = 128, .gutter = 4};
//     const umbrage::shadow sun(umbrage::adaptive_maps(root, cache, size), glm::ivec2(size.pitch()), filter);
//     umbrage::draw_pages(atlas, size, root, drawn, draw);  // only new pages; sun.draw(atlas, mesh) draws all
//
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/page_places.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

/// Setup of the pages of an adaptive shadow map.
struct adaptive_maps {
    light_space<double> root;
    std::vector<placed_page> pages;  ///< coarse pages first
    page_size size;

    /// @param space   light from make_page_root
    /// @param cache   cache after its update. Make the shadow again for each frame; its shader stays the same
    /// @param of      size of a page, with a gutter of the filter's reach or more
    /// @throws std::invalid_argument  more than 8 columns or rows of slots; a deepest level above 4; a page size that
    ///                                page_light refuses
    template <real T>
    adaptive_maps(const light_space<T>& space, const page_cache& cache, page_size of = {})
        : root(detail::in_double(space)), size(of) {
        constexpr auto function = "adaptive_maps", instead = "A page table in a texture takes more: page_coordinate.";
        const page_budget& budget = cache.budget();
        detail::require(budget.slots.x <= grid.columns && budget.slots.y <= grid.rows, function, "cache.slots",
                        "8 x 8 or fewer", budget.slots, instead);
        detail::require(budget.deepest_level <= deepest_level, function, "cache.deepest_level", "4 or less",
                        budget.deepest_level, instead);
        static_cast<void>(page_light(root, umbrage::page{}, size));  // checks the size
        cache.for_each([&](const page& p, glm::ivec2 slot) { pages.push_back({p, slot}); });
    }

    struct uniforms {
        glm::mat4 to_root;  ///< page_matrix
        glm::mat4 planes;   ///< plane_matrix in texels of the deepest level
        /// 16 x 16 cells of the deepest level, row by row. A cell is slot + 64 (2^level - 1). Each number holds two
        /// cells: first + 1024 second
        std::array<glm::mat4, 8> cells;
        glm::vec4 anchor;  ///< xyz: middle of the root page
        glm::vec4 pages;   ///< x: size of a page, y: width of its gutter, texels
        glm::vec4 slack;   ///< of a plane, as adaptive_maps_places takes it
    };
    static constexpr uniform_field fields[]{
        {"to_root"}, {"planes"},  {"cells_0"}, {"cells_1"},       {"cells_2"},      {"cells_3"},     {"cells_4"},
        {"cells_5"}, {"cells_6"}, {"cells_7"}, {"anchor", false}, {"pages", false}, {"slack", false}};
    static constexpr map_grid grid{page_tile_columns, 8};
    static constexpr int deepest_level = 4;
    static constexpr outside_map outside = outside_map::clamped;

    [[nodiscard]] clip_space clip() const { return root.clip; }
    /// Lights by slot, row by row, up to the last slot that holds a page. An empty slot has the root page's light.
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        std::vector<light_space<double>> all{page_light(root, umbrage::page{}, size)};
        for (const auto& [page, slot] : pages) {
            const std::size_t number = number_of(slot);
            if (number >= all.size()) all.resize(number + 1, page_light(root, umbrage::page{}, size));
            all[number] = page_light(root, page, size);
        }
        return all;
    }
    /// @throws std::invalid_argument  a filter's reach above the gutter
    void require_reach(float reach) const { detail::require_reach("shadow", "light.size.gutter", size.gutter, reach); }
    /// @throws std::invalid_argument  a map_size other than a page's with its gutter
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(size.pitch()), "shadow", "map_size", "the pages' pitch()");
        const light_space<double> here = detail::relative_to(origin, root);
        const glm::ivec2 texels(size.texels << deepest_level);
        const glm::dmat4 in_texels = texture_matrix(here, texels);
        const glm::dvec3 anchor = detail::in_binary32(detail::anchor_of(in_texels, texels));
        const auto moved = [&](const glm::dmat4& m) { return detail::moved_to(m, anchor); };
        const glm::dvec4 error = detail::rounding_of(moved(in_texels), texels, anchor);
        uniforms u{};
        u.to_root = glm::mat4(moved(page_matrix(here)));
        u.planes = glm::mat4(detail::plane_matrix_of_shadow(moved(in_texels)));
        u.anchor = glm::vec4(glm::vec3(anchor), 0.0f);
        const double coordinate = 8.0 * detail::one_rounding;  // of 1 to 2 across the root, on both sides
        u.pages = glm::vec4(float(size.texels), float(size.gutter), 0.0f, 0.0f);
        u.slack = glm::vec4(glm::dvec4(detail::texels_beside_plane(root.clip, map_size),
                                       error.z + coordinate * texels.x, error.w + 6.0 * detail::one_rounding,
                                       detail::width_in_depth(moved(in_texels), texels)));
        int codes[side * side]{};
        for (const auto& [page, slot] : pages) {
            const int wide = side >> page.level,
                      code = static_cast<int>(number_of(slot)) + 64 * ((1 << page.level) - 1);
            for (int y = page.y * wide; y < (page.y + 1) * wide; ++y)
                std::fill_n(codes + y * side + page.x * wide, wide, code);
        }
        for (glm::length_t i = 0; i < side * side; i += 2)
            u.cells[static_cast<std::size_t>(i / 32)][i / 8 % 4][i / 2 % 4] =
                static_cast<float>(codes[i] + 1024 * codes[i + 1]);
        return u;
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 1> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return adaptive_maps_places(u.to_root, u.planes, u.cells, u.anchor, u.pages, u.slack, terms, world, normal);
    }
    static constexpr const glsl::snippet* placing = &glsl::adaptive_maps_places;

private:
    static constexpr int side = 1 << deepest_level;

    [[nodiscard]] static std::size_t number_of(glm::ivec2 slot) {
        return static_cast<std::size_t>(slot.y * grid.columns + slot.x);
    }
};

}  // namespace umbrage
