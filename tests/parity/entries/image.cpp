// SPDX-License-Identifier: MIT
#include <umbrage/image.hpp>

#include "entries.hpp"

namespace parity {

void add_image(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    for (const bool packed : {false, true}) {
        const std::string variant = packed ? "packed map" : "";
        const auto maps = packed ? packed_maps() : depth_maps();
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
}

}  // namespace parity
