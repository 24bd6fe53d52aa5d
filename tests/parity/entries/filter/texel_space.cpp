// SPDX-License-Identifier: MIT
#include <umbrage/filter/texel_space.hpp>

#include "../entries.hpp"

namespace parity {

void add_filter_texel_space(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back({.primitive = &glsl::fetch_depth,
                   .classes = whole_texels(),
                   .twin = [](const sample& s) { return vec4(fetch_depth(s.depth(), texel_of(s))); },
                   .call = "vec4(umbrage_fetch_depth(map, map_size, vec2(x0.x, x0.y)))",
                   .maps = depth_maps()});
    all.push_back({.primitive = &glsl::inside_texel_space,
                   .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(inside_texel_space(vec2(s.x[0])) ? 1.0f : 0.0f); },
                   .call = "vec4(umbrage_inside_texel_space(vec2(x0.x, x0.y)) ? 1.0 : 0.0)",
                   .maps = depth_maps()});
}

}  // namespace parity
