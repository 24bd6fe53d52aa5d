// SPDX-License-Identifier: MIT
#include <umbrage/core/image.hpp>

#include <glm/common.hpp>

#include "../entries.hpp"

namespace parity {

void add_core_image(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    for (const bool packed : {false, true}) {
        const std::string variant = packed ? "packed map" : "";
        const auto maps = packed ? packed_maps() : depth_maps();
        all.push_back({.primitive = &glsl::texel,
                       .variant = variant,
                       .classes = whole_texels(),
                       .twin =
                           [](const sample& s) {
                               const ivec2 last = s.map.size - 1;
                               return texel(s.map, glm::clamp(texel_of(s), ivec2(0), last));
                           },
                       .call = "umbrage_texel(map, map_size, clamp(vec2(x0.x, x0.y), vec2(0.0, 0.0), map_size - 1.0))",
                       .maps = maps});
        all.push_back({.primitive = &glsl::fetch_clamped,
                       .variant = variant,
                       .classes = whole_texels(),
                       .twin = [](const sample& s) { return fetch_clamped(s.map, texel_of(s)); },
                       .call = "umbrage_fetch_clamped(map, map_size, vec2(x0.x, x0.y))",
                       .maps = maps});
        all.push_back(
            {.primitive = &glsl::fetch_bordered,
             .variant = variant,
             .classes = whole_texels(),
             .twin = [](const sample& s) { return fetch_bordered(s.map, texel_of(s), vec4(0.25f, 0.5f, 2.0f, 1.0f)); },
             .call = "umbrage_fetch_bordered(map, map_size, vec2(x0.x, x0.y), vec4(0.25, 0.5, 2.0, 1.0))",
             .maps = maps});
    }
    all.push_back(
        {.primitive = &glsl::texel,
         .variant = "region",
         .classes = whole_texels(),
         .twin =
             [](const sample& s) { return vec4(texel(s.map, glm::clamp(texel_of(s), ivec2(0), s.map.size - 1)).x); },
         .call = "vec4(umbrage_texel(map, map_size, clamp(vec2(x0.x, x0.y), vec2(0.0, 0.0), map_size - 1.0)).x)",
         .maps = depth_maps(),
         .bound = {{.name = "map", .as = {.origin = "vec2(5.0, 3.0)", .texture_size = "(size + vec2(9.0, 7.0))"}}}});
    all.push_back({.primitive = &glsl::inside_map,
                   .classes = whole_texels(),
                   .twin = [](const sample& s) { return vec4(inside_map(s.map.size, texel_of(s)) ? 1.0f : 0.0f); },
                   .call = "vec4(umbrage_inside_map(map_size, vec2(x0.x, x0.y)) ? 1.0 : 0.0)",
                   .maps = depth_maps()});
    for (const auto outside : {outside_map::bordered, outside_map::clamped})
        all.push_back({.primitive = &glsl::texel_inside,
                       .variant = outside == outside_map::bordered ? "" : "clamped",
                       .classes = whole_texels(),
                       .twin =
                           [outside](const sample& s) {
                               const ivec2 at = texel_of(s), nearest = glm::clamp(at, ivec2(0), s.map.size - 1);
                               const bool any = outside == outside_map::bordered;
                               return vec4(any ? texel_inside(s.map.size, at) : nearest, 0, 0);
                           },
                       .call = "vec4(umbrage_texel_inside(map_size, vec2(x0.x, x0.y)), 0.0, 0.0)",
                       .maps = depth_maps(),
                       .map_kind = {.outside = outside}});
}

}  // namespace parity
