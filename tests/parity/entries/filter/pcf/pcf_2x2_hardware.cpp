// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

#include "../../entries.hpp"

namespace parity {

void add_filter_pcf_pcf_2x2_hardware(std::vector<entry>& all) {
    using namespace umbrage;
    using glsl::binding;
    using glsl::texture;

    all.push_back(filter(glsl::pcf_2x2_hardware, "",
                         [](const sample& s) { return vec4(pcf_2x2_hardware(s.depth(), at(s), s.x[0].z)); }));
    const std::pair<const char*, binding> samplers[]{
        {"shadow", {.texture = texture::shadow}},
        {"shadow, reversed, lit outside",
         {.texture = texture::shadow, .direction = depth_direction::reversed, .outside_lit = true}},
        {"shadow region, lit outside", {.texture = texture::shadow, .outside_lit = true, .origin = "vec2(5.0, 3.0)"}},
        {"shadow array, reversed", {.texture = texture::shadow_array, .direction = depth_direction::reversed}}};
    for (const auto& [name, as] : samplers) {
        const bound_map m{.name = "map", .as = as, .linear = true};
        all.push_back({.primitive = &glsl::pcf_2x2_hardware,
                       .variant = name,
                       .classes = receivers(),
                       .twin =
                           [direction = as.direction, outside_lit = as.outside_lit](const sample& s) {
                               const comparison is_lit{direction};
                               return vec4(outside_lit ? pcf_2x2_hardware(s.bordered_depth(cleared_depth(direction)),
                                                                          at(s), s.x[0].z, is_lit)
                                                       : pcf_2x2_hardware(s.depth(), at(s), s.x[0].z, is_lit));
                           },
                       .call = "vec4(umbrage_pcf_2x2_hardware(map, map_size, vec2(x0.x, x0.y), x0.z))",
                       .maps = plain_maps({{64, 64}, {37, 21}, {3, 2}, {1, 1}}),
                       .bound = {m},
                       .share = 16});
    }
}

}  // namespace parity
