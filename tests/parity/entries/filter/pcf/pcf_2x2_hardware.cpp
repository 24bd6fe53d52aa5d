// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

#include <cmath>

#include "../../entries.hpp"

namespace parity {

void add_filter_pcf_pcf_2x2_hardware(std::vector<entry>& all) {
    using namespace umbrage;
    using glsl::texture;

    all.push_back(
        filter(glsl::lit_filtered, "", [](const sample& s) { return vec4(lit_filtered(s.depth(), at(s), s.x[0].z)); }));
    for (input_class& c : all.back().classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            for (int axis : {0, 1})
                if (std::isnan(s.x[0][axis])) s.x[0][axis] = 0.5f;
        };
    const auto near_map = [](entry& e) {
        for (input_class& c : e.classes)
            c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
                fill(i, r, s);
                for (int axis : {0, 1})  // far off, 1/128 texel is lost by the division
                    if (!(std::abs(s.x[0][axis]) < 256.0f)) s.x[0][axis] = 0.5f;
            };
    };
    all.push_back(filter(glsl::lit_between, "", [](const sample& s) {
        return vec4(lit_between(s.depth(), vec2(s.map.size), at(s) / vec2(s.map.size), s.x[0].z));
    }));
    all.back().call = "vec4(umbrage_lit_between(map, map_size, vec2(x0.x, x0.y) / map_size, vec2(0.5, 0.5), x0.z))";
    near_map(all.back());
    all.push_back(filter(glsl::covered, "", [](const sample& s) {
        return vec4(covered(vec2(s.map.size), at(s) / vec2(s.map.size)), 0.0f, 0.0f);
    }));
    all.back().call = "vec4(umbrage_covered(map_size, vec2(x0.x, x0.y) / map_size), 0.0, 0.0)";
    all.push_back(filter(glsl::lit_at, "", [](const sample& s) {
        return vec4(lit_at(s.depth(), vec2(s.map.size), at(s) / vec2(s.map.size), s.x[0].z));
    }));
    all.back().call = "vec4(umbrage_lit_at(map, map_size, vec2(x0.x, x0.y) / map_size, vec2(x0.x, x0.y), x0.z))";
    near_map(all.back());
    all.push_back(filter(glsl::pcf_2x2_hardware, "",
                         [](const sample& s) { return vec4(pcf_2x2_hardware(s.depth(), at(s), s.x[0].z)); }));
    const std::pair<const char*, glsl::binding> samplers[]{
        {"shadow", {.texture = texture::shadow, .outside = outside_map::clamped}},
        {"shadow, reversed, lit outside", {.texture = texture::shadow, .direction = depth_direction::reversed}},
        {"shadow region", {.texture = texture::shadow, .origin = "vec2(5.0, 3.0)"}},
        {"shadow region, lit outside",
         {.texture = texture::shadow, .outside = outside_map::bordered, .origin = "vec2(5.0, 3.0)"}},
        {"shadow array, reversed",
         {.texture = texture::shadow_array, .direction = depth_direction::reversed, .outside = outside_map::clamped}}};
    for (const auto& [name, as] : samplers)
        all.push_back(sampled_filter(
            glsl::pcf_2x2_hardware, "", name, as,
            [](auto fetch, const sample& s, auto is_lit) { return pcf_2x2_hardware(fetch, at(s), s.x[0].z, is_lit); }));
}

}  // namespace parity
