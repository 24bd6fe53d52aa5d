// SPDX-License-Identifier: MIT
//
// Adaptive shadow map (virtual shadow map) with up to 64 pages, each of them a map. The uniform block holds the table
// that finds a receiver's page, so the deepest level is 4. page_coordinate reads a table of more pages and levels from
// a texture.
//
//     umbrage::page_cache cache({.slots = {8, 8}, .deepest_level = 4});
//     const auto drawn = cache.update(seen).drawn;          // each frame; see light/adaptive/README.md
//     const umbrage::page_size size{.texels = 128, .gutter = 4};
//     const umbrage::shadow sun(umbrage::adaptive_maps(root, cache, size), glm::ivec2(size.pitch()), filter);
//     umbrage::draw_pages(atlas, size, root, drawn, draw);  // only new pages; sun.draw(atlas, mesh) draws all
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Setup of the pages of an adaptive shadow map.
struct adaptive_maps {
    light_space<double> root;
    std::vector<placed_page> pages;  ///< coarse pages first
    page_size size;

    /// @param space   light from make_page_root
    /// @param cache   cache after its update. Make the shadow again for each frame; its shader stays the same
    /// @param of      size of a page, with a gutter of the filter's radius + 1/2 texels or more
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
        glm::mat4 to_root;   ///< page_matrix
        glm::mat4 planes;    ///< plane_matrix in texels of the deepest level
        glm::mat4 cells[8];  ///< 16 x 16 cells of the deepest level, row by row. A cell is slot + 64 (2^level - 1).
                             ///< Each number holds two cells: first + 1024 second
        glm::vec4 pages;     ///< x: size of a page, y: width of its gutter, texels
    };
    static constexpr uniform_field fields[]{{"to_root"}, {"planes"},  {"cells_0"},     {"cells_1"},
                                            {"cells_2"}, {"cells_3"}, {"cells_4"},     {"cells_5"},
                                            {"cells_6"}, {"cells_7"}, {"pages", false}};
    static constexpr map_grid grid{page_tile_columns, 8};
    static constexpr int deepest_level = 4;
    static constexpr outside_map outside = outside_map::clamped;
    static constexpr glsl::map_choice tiles{true, glsl::page_tile.name};

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
    /// Refuses a filter that reads beyond the gutter: each page would end in a line.
    /// @param reach   distance from a receiver to the farthest texel that counts, texels
    /// @throws std::invalid_argument  a reach above the gutter
    void require_reach(float reach) const {
        detail::require(float(size.gutter) >= reach, "shadow", "light.size.gutter",
                        std::string("the filter's reach or more, ").append(detail::printed(reach)), size.gutter);
    }
    /// @throws std::invalid_argument  a map_size other than a page's with its gutter
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        detail::require_size(map_size, glm::ivec2(size.pitch()), "shadow", "map_size", "the pages' pitch()");
        const light_space<double> here = detail::relative_to(origin, root);
        const glm::dmat4 in_texels = texture_matrix(here, glm::ivec2(size.texels << deepest_level));
        uniforms u{glm::mat4(page_matrix(here)), glm::mat4(plane_matrix(in_texels)), {}, {}};
        u.pages = {size.texels, size.gutter, 0, 0};
        int codes[side * side]{};
        for (const auto& [page, slot] : pages) {
            const int wide = side >> page.level,
                      code = static_cast<int>(number_of(slot)) + 64 * ((1 << page.level) - 1);
            for (int y = page.y * wide; y < (page.y + 1) * wide; ++y)
                std::fill_n(codes + y * side + page.x * wide, wide, code);
        }
        for (glm::length_t i = 0; i < side * side; i += 2)
            u.cells[i / 32][i / 8 % 4][i / 2 % 4] = static_cast<float>(codes[i] + 1024 * codes[i + 1]);
        return u;
    }

    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms&, glm::vec3 world, glm::vec3 normal,
                                          const Look& look) {
        const glm::vec3 in_root(shadow_coordinate(u.to_root, world));
        const auto within = [](float v) { return !is_nan(v) && v >= 1.0f && v < 2.0f; };
        const bool inside = within(in_root.x) && within(in_root.y);
        const glm::vec2 coord = inside ? glm::vec2(in_root) : glm::vec2(1);
        const int i = static_cast<int>(coord.y * 16.0f - 16.0f) * side + static_cast<int>(coord.x * 16.0f - 16.0f);
        const auto cell = static_cast<glm::length_t>(i);
        const int two = static_cast<int>(u.cells[cell / 32][cell / 8 % 4][cell / 2 % 4]);
        const int code = i % 2 == 0 ? two % 1024 : two / 1024;
        const float across = static_cast<float>(code / 64 + 1);
        const glm::vec2 place = coord * across;
        const glm::vec2 at = inside ? (place - glm::floor(place)) * u.pages.x + u.pages.y : glm::vec2(32768);
        const glm::vec2 slope = receiver_slope(u.planes, normal, world) * (16.0f / across);
        return look(map_place{code % 64, glm::vec3(at, in_root.z), {clamp_slope(slope.x), clamp_slope(slope.y)}});
    }
    [[nodiscard]] static std::string text(const glsl::map_choice& choice) {
        return R"GLSL(
    UMBRAGE_HIGHP vec4 in_root = umbrage_shadow_coordinate(to_root, world);
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
    UMBRAGE_HIGHP float number = code - before * 64.0;
    UMBRAGE_HIGHP float across = before + 1.0;
    UMBRAGE_HIGHP vec2 place = coord * across;
    UMBRAGE_HIGHP vec2 within = (place - floor(place)) * pages.x + pages.y;
    UMBRAGE_HIGHP vec2 at = inside ? within : vec2(32768.0, 32768.0);
    UMBRAGE_HIGHP vec2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    UMBRAGE_HIGHP vec2 slope = vec2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
)GLSL" + choice.first("number") +
               "    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, in_root.z), slope);\n";
    }
    static constexpr const auto& needs = glsl::list<&glsl::shadow_coordinate, &glsl::cascade_column_8,
                                                    &glsl::receiver_slope, &glsl::clamp_slope, &glsl::page_tile>;

private:
    static constexpr int side = 1 << deepest_level;

    [[nodiscard]] static std::size_t number_of(glm::ivec2 slot) {
        return static_cast<std::size_t>(slot.y * grid.columns + slot.x);
    }
};

}  // namespace umbrage
