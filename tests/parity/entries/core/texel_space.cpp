// SPDX-License-Identifier: MIT
#include <umbrage/core/texel_space.hpp>

#include <cmath>

#include "../filter/off_borders.hpp"

namespace parity {
namespace {

/// whole_texels() with a receiver in x0.z: a depth on the maps' lattice, beside it, NaN, or beyond the planes.
std::vector<input_class> compared_texels() {
    auto classes = whole_texels();
    for (input_class& c : classes)
        c.fill = [texel = c.fill](std::uint64_t i, random& r, sample& s) {
            texel(i, r, s);
            const float lattice = static_cast<float>(r.below(17)) / 16.0f;
            const float depths[] = {lattice, r.between(-0.5f, 1.5f), lattice, std::nanf("")};
            s.x[0].z = depths[r.below(4)];
        };
    return classes;
}

}  // namespace

void add_core_texel_space(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::fetch_depth,
                   .classes = whole_texels(),
                   .twin = [](const sample& s) { return vec4(fetch_depth(s.depth(), texel_of(s))); },
                   .call = "vec4(umbrage_fetch_depth(map, map_size, vec2(x0.x, x0.y)))",
                   .maps = depth_maps()});
    all.push_back({.primitive = &glsl::depth_at,
                   .classes = points_of_texels(),
                   .twin = [](const sample& s) { return vec4(fetch_depth(s.depth(), ivec2(glm::floor(at(s))))); },
                   .call = "vec4(umbrage_depth_at(map, map_size, vec2(x0.x, x0.y) / map_size))",
                   .maps = depth_maps()});
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const bool forward = direction == depth_direction::forward;
        all.push_back({.primitive = &glsl::fetch_depth,
                       .variant = forward ? "lit outside" : "lit outside, reversed",
                       .classes = whole_texels(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(fetch_depth(s.bordered_depth(cleared_depth(direction)), texel_of(s)));
                           },
                       .call = "vec4(umbrage_fetch_depth(map, map_size, vec2(x0.x, x0.y)))",
                       .maps = depth_maps(),
                       .map_kind = {.direction = direction}});
    }
    all.push_back({.primitive = &glsl::inside_texel_space,
                   .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(inside_texel_space(vec2(s.x[0])) ? 1.0f : 0.0f); },
                   .call = "vec4(umbrage_inside_texel_space(vec2(x0.x, x0.y)) ? 1.0 : 0.0)",
                   .maps = depth_maps()});
    for (const auto outside : {outside_map::bordered, outside_map::clamped})
        all.push_back(
            {.primitive = &glsl::map_covers,
             .variant = outside == outside_map::bordered ? "" : "clamped",
             .classes = receivers(),
             .twin = [outside](
                         const sample& s) { return vec4(map_covers(vec2(s.map.size), at(s), outside) ? 1.0f : 0.0f); },
             .call = "vec4(umbrage_map_covers(map_size, vec2(x0.x, x0.y)) ? 1.0 : 0.0)",
             .maps = depth_maps(),
             .map_kind = {.outside = outside}});
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        all.push_back({.primitive = &glsl::in_filter_domain,
                       .variant = direction == depth_direction::forward ? "" : "reversed",
                       .classes = receivers(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(in_filter_domain(vec2(s.x[0]), s.x[0].z, comparison{direction}) ? 1.0f
                                                                                                           : 0.0f);
                           },
                       .call = "vec4(umbrage_in_filter_domain(vec2(x0.x, x0.y), x0.z) ? 1.0 : 0.0)",
                       .maps = depth_maps(),
                       .map_kind = {.direction = direction, .outside = outside_map::clamped}});
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const bool forward = direction == depth_direction::forward;
        all.push_back({.primitive = &glsl::lit,
                       .variant = forward ? "" : "reversed",
                       .classes = compared_texels(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(lit(s.depth(), texel_of(s), s.x[0].z, comparison{direction}));
                           },
                       .call = "vec4(umbrage_lit(map, map_size, vec2(x0.x, x0.y), x0.z))",
                       .maps = depth_maps(),
                       .map_kind = {.direction = direction, .outside = outside_map::clamped}});
        all.push_back(
            {.primitive = &glsl::lit_2x2,
             .variant = forward ? "" : "reversed",
             .classes = compared_texels(),
             .twin = [direction](
                         const sample& s) { return lit_2x2(s.depth(), texel_of(s), s.x[0].z, comparison{direction}); },
             .call = "umbrage_lit_2x2(map, map_size, vec2(x0.x, x0.y), x0.z)",
             .maps = depth_maps(),
             .map_kind = {.direction = direction, .outside = outside_map::clamped}});
    }
}

}  // namespace parity
