// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include <umbrage/depth/rg.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Every fraction of 1/256 in both directions with every outcome of the four comparisons, somewhere on the map.
enumeration all_weights() {
    return {{"256 x 256 fractions, 16 masks",
             [](std::uint64_t i, random& r, sample& s) {
                 const auto depth = s.depth();
                 for (;;) {
                     const ivec2 texel{r.below(s.map.size.x - 1), r.below(s.map.size.y - 1)};
                     const float taps[] = {depth(texel), depth(texel + ivec2(1, 0)), depth(texel + ivec2(0, 1)),
                                           depth(texel + ivec2(1, 1))};
                     const float receiver = r.below(8) == 0 ? 2.0f : taps[r.below(4)];
                     std::uint64_t mask = 0;
                     for (int t = 0; t < 4; ++t) mask |= std::uint64_t(receiver <= taps[t]) << t;
                     if (mask != (i & 15)) continue;
                     const vec2 fraction(static_cast<float>(i >> 4 & 255), static_cast<float>(i >> 12));
                     s.x[0] = vec4(vec2(texel) + 0.5f + fraction / 256.0f, receiver, 0.0f);
                     return;
                 }
             }},
            1 << 20};
}

}  // namespace

void add_filter_pcf_pcf_2x2(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back(filter(
        glsl::pcf_2x2, "", [](const sample& s) { return vec4(pcf_2x2(s.depth(), at(s), s.x[0].z)); }, all_weights()));
    all.push_back(filter(glsl::pcf_2x2_dx_sdk, ", 0.015625",
                         [](const sample& s) { return vec4(pcf_2x2_dx_sdk(s.depth(), at(s), s.x[0].z, 0.015625f)); }));
    all.push_back(reversed_filter(
        glsl::pcf_2x2, "", [](const sample& s) { return vec4(pcf_2x2(s.depth(), at(s), s.x[0].z, greater_equal{})); }));
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const bool forward = direction == depth_direction::forward;
        all.push_back({.primitive = &glsl::pcf_2x2,
                       .variant = forward ? "lit outside" : "lit outside, reversed",
                       .classes = receivers(),
                       .twin =
                           [direction](const sample& s) {
                               return vec4(pcf_2x2(s.bordered_depth(cleared_depth(direction)), at(s), s.x[0].z,
                                                   comparison{direction}));
                           },
                       .call = "vec4(umbrage_pcf_2x2(map, map_size, vec2(x0.x, x0.y), x0.z))",
                       .maps = depth_maps(),
                       .map_kind = {.direction = direction}});
    }
    all.push_back({.primitive = &glsl::pcf_2x2,
                   .variant = "packed map",
                   .classes = receivers(),
                   .twin =
                       [](const sample& s) {
                           const auto depth = [view = s.map](ivec2 texel) {
                               return decode_rg<11>(vec2(fetch_clamped(view, texel)), 0.5f);
                           };
                           return vec4(pcf_2x2(depth, at(s), s.x[0].z));
                       },
                   .call = "vec4(umbrage_pcf_2x2(map, map_size, vec2(x0.x, x0.y), x0.z))",
                   .maps = packed_maps(),
                   .map_kind = {.outside = outside_map::clamped,
                                .depth = "umbrage_decode_rg11(value.xy, 0.5)",
                                .channels = 2,
                                .needs = {glsl::decode_rg<11>}}});
}

}  // namespace parity
