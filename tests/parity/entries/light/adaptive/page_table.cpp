// SPDX-License-Identifier: MIT
#include <umbrage/light/adaptive/page_table.hpp>

#include <cmath>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Pages of every level side by side, and cells without one, as around them.
texels entries_of_pages() {
    texels t({34, 34});
    random r(2001);
    for (ivec2 cell(1); cell.y < 33; ++cell.y)
        for (cell.x = 1; cell.x < 33; ++cell.x) {
            const auto column = static_cast<int>(r.below(30)), row = static_cast<int>(r.below(30));
            const auto level = static_cast<int>(r.below(17));
            t[cell] = level > deepest_page_level ? vec4(0.0f) : load_unorm(page_entry({column, row}, level));
        }
    return t;
}

/// Receivers in x0.xy: in the root and around it, at cells' borders, special values but no NaN, of which texels that
/// filters do not read depend.
std::vector<input_class> in_root() {
    auto kinds = special_values();
    std::erase_if(kinds, [](const value_class& k) { return k.name == "NaN" || k.name == "infinity"; });
    kinds.push_back({"at a border", [](std::uint64_t i, random& r) {
                         const float border = 1.0f + static_cast<float>(r.below(33)) / 32.0f;
                         return i % 3 == 0 ? border : std::nextafter(border, i % 3 == 1 ? 0.0f : 9.0f);
                     }});
    return spread({{0.9375f, 2.0625f}, {0.9375f, 2.0625f}}, kinds);
}

}  // namespace

void add_light_adaptive_page_table(std::vector<entry>& all) {
    all.push_back({.primitive = &umbrage::glsl::page_coordinate,
                   .classes = in_root(),
                   .twin =
                       [](const sample& s) {
                           const auto fetch = [&](ivec2 cell) {
                               return glm::u8vec4(from_unorm(fetch_clamped(s.table, cell)));
                           };
                           return page_coordinate(fetch, 34.0f, vec2(s.x[0]), 128.0f, 4.0f);
                       },
                   .call = "umbrage_page_coordinate(table, vec2(34.0, 34.0), vec2(x0.x, x0.y), 128.0, 4.0)",
                   .table = entries_of_pages()});
    all.push_back(
        {.primitive = &umbrage::glsl::page_tile,
         .classes = {{"numbers", [](std::uint64_t, random& r,
                                    sample& s) { s.x[0] = vec4(static_cast<float>(r.below(64)), 0.0f, 0.0f, 0.0f); }}},
         .twin = [](const sample& s) { return vec4(vec2(page_tile(static_cast<int>(s.x[0].x), 136)), 0.0f, 1.0f); },
         .call = "vec4(umbrage_page_tile(x0.x, 136.0), 0.0, 1.0)"});
}

}  // namespace parity
