// SPDX-License-Identifier: MIT
//
// What a map can be, as functions: bind() puts these in place of the hooks' texts for a shader's one map. Words that a
// map fills in: UMBRAGE_MAP map, what it is called with; UMBRAGE_ORIGIN, its first texel in the texture; UMBRAGE_DEPTH,
// the depth of a `value`; UMBRAGE_UV, what the sampler takes for `at`; and those that read the texture at `at` or `uv`.
//
#pragma once

#include <umbrage/shader/texel_hooks.hpp>

namespace umbrage::glsl::hooks {

// The sampler weighs: coordinates stay half a texel inside, so that what is beside the map has no weight.

inline constexpr snippet clamped_lit_filtered{.name = "lit_filtered",
                                              .summary = "lit_filtered, clamped",
                                              .exactness = tier::c,
                                              .within = 1.0f / 128.0f,
                                              .needs = list<&within_far_plane>,
                                              .role = hook::chosen,
                                              .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
)GLSL"};

inline constexpr snippet bordered_lit_filtered{.name = "lit_filtered",
                                               .summary = "lit_filtered, bordered",
                                               .exactness = tier::c,
                                               .within = 1.0f / 128.0f,
                                               .needs = list<&within_far_plane, &compare, &cleared_depth>,
                                               .role = hook::chosen,
                                               .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP vec2 inside = clamp(min(coord, size - coord) + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, umbrage_cleared_depth());
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
)GLSL"};

// Where a map is all of its texture, uv over the map is what the sampler takes, and the sampler clamps to the edge.

inline constexpr snippet sampled_lit{.name = "lit_at",
                                     .summary = "lit_at, sampled",
                                     .exactness = tier::c,
                                     .within = 1.0f / 128.0f,
                                     .role = hook::chosen,
                                     .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
)GLSL"};

inline constexpr snippet sampled_depth{.name = "depth_at",
                                       .summary = "depth_at, sampled",
                                       .exactness = tier::c,
                                       .operations = 4,
                                       .needs = list<&decode>,
                                       .role = hook::chosen,
                                       .source = R"GLSL(
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
)GLSL"};

/// Every one of them, for printers and packages.
inline constexpr const auto& all =
    list<&forward_cleared_depth, &reversed_cleared_depth, &forward_beyond_far, &reversed_beyond_far, &scaled_beyond_far,
         &forward_before_far, &reversed_before_far, &forward_compare, &reversed_compare, &texel, &decode,
         &clamped_depth, &bordered_depth, &lit_texel, &clamped_lit, &bordered_lit, &gather_compared,
         &gather_one_channel, &gather_two_channels, &gathered, &gathered_region, &gathered_bordered,
         &clamped_lit_filtered, &bordered_lit_filtered, &sampled_lit, &sampled_depth>;

}  // namespace umbrage::glsl::hooks
