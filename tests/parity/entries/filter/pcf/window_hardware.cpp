// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/window_hardware.hpp>

#include <umbrage/filter/pcf/windows.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// By the sampler of some kinds of map, and of a map without one.
void add(std::vector<entry>& all, const snippet& one, const std::string& numbers, const window_row& row,
         std::initializer_list<std::pair<const char*, umbrage::glsl::binding>> samplers) {
    all.push_back(filter(one, numbers,
                         [row](const sample& s) { return vec4(window_hardware(s.depth(), at(s), s.x[0].z, row)); }));
    all.back().share = static_cast<std::size_t>(row.size * row.size);
    for (const auto& [name, as] : samplers)
        all.push_back(sampled_filter(one, numbers, name, as, [row](auto fetch, const sample& s, auto is_lit) {
            return window_hardware(fetch, at(s), s.x[0].z, row, is_lit);
        }));
}

}  // namespace

void add_filter_pcf_window_hardware(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using glsl::texture;
    add(all, glsl::window_hardware<3>, ", 4.0, 8.0", tent_row<3>,
        {{"shadow", {.texture = texture::shadow, .outside = outside_map::clamped}},
         {"shadow region, lit outside",
          {.texture = texture::shadow, .outside = outside_map::bordered, .origin = "vec2(5.0, 3.0)"}}});
    add(all, glsl::window_hardware<5>, ", 0.25, 0.75, 1.0", make_window_row(5, {0.25f, 0.75f, 1}, 128),
        {{"shadow, reversed, lit outside", {.texture = texture::shadow, .direction = depth_direction::reversed}}});
    add(all, glsl::window_hardware<7>, ", 0.0625, 0.3125, 0.75, 1.0",
        make_window_row(7, {0.0625f, 0.3125f, 0.75f, 1}, 32),
        {{"shadow array, reversed",
          {.texture = texture::shadow_array,
           .direction = depth_direction::reversed,
           .outside = outside_map::clamped}}});
}

}  // namespace parity
