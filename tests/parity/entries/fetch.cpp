// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/common.hpp>

#include <umbrage/filter/texel_space.hpp>

#include "entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Whole texel numbers in x0.xy: inside, around the border, far off.
std::vector<input_class> whole_texels() {
    return {{"random", [](auto, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c) s.x[0][c] = static_cast<float>(r.below(s.map.size[c]));
             }},
            {"texel edges", [](std::uint64_t i, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c)
                     s.x[0][c] = static_cast<float>(((i >> c & 1) ? s.map.size[c] : 0) + r.below(5) - 2);
             }},
            {"out of range", [](auto, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c) s.x[0][c] = std::floor(r.between(-32768.0f, 32768.0f));
             }}};
}

ivec2 texel_of(const sample& s) { return ivec2(vec2(s.x[0])); }

}  // namespace

void add_fetch(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    for (const bool packed : {false, true}) {
        const std::string variant = packed ? "packed map" : "";
        const auto maps = packed ? packed_maps() : depth_maps();
        all.push_back({.primitive = &glsl::fetch_clamped, .variant = variant, .classes = whole_texels(),
                       .twin = [](const sample& s) { return fetch_clamped(s.map, texel_of(s)); },
                       .call = "umbrage_fetch_clamped(map, map_size, vec2(x0.x, x0.y))", .maps = maps});
        all.push_back({.primitive = &glsl::fetch_bordered, .variant = variant, .classes = whole_texels(),
                       .twin = [](const sample& s) { return fetch_bordered(s.map, texel_of(s), vec4(0.25f, 0.5f, 2.0f, 1.0f)); },
                       .call = "umbrage_fetch_bordered(map, map_size, vec2(x0.x, x0.y), vec4(0.25, 0.5, 2.0, 1.0))", .maps = maps});
    }
    all.push_back({.primitive = &glsl::fetch_depth, .classes = whole_texels(),
                   .twin = [](const sample& s) { return vec4(fetch_depth(s.depth(), texel_of(s))); },
                   .call = "vec4(umbrage_fetch_depth(map, map_size, vec2(x0.x, x0.y)))", .maps = depth_maps()});
    all.push_back({.primitive = &glsl::inside_texel_space, .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(inside_texel_space(vec2(s.x[0])) ? 1.0f : 0.0f); },
                   .call = "vec4(umbrage_inside_texel_space(vec2(x0.x, x0.y)) ? 1.0 : 0.0)", .maps = depth_maps()});
}

}  // namespace parity
