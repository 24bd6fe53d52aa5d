// SPDX-License-Identifier: MIT
//
// Hooks for each kind of map, part 2. bind() puts one of these functions in place of a hook's own text, which is that
// of a plain map. The map fills in these words:
//   UMBRAGE_MAP map   its parameters
//   UMBRAGE_ORIGIN    its first texel in the texture
//   UMBRAGE_DEPTH     the depth of a `value`, or the far plane's where the receiver's plane is lit
//   UMBRAGE_STORED    the depth of a `value`
//   UMBRAGE_REFERENCE the depth of the receiver's plane that a `texel` is compared with
//   UMBRAGE_CORNER    the same where four texels meet, a `texel` between them
//   UMBRAGE_BORDER    the depth outside
//   UMBRAGE_COMPARE   a user's own comparison
//   UMBRAGE_UV        texture coordinates for `at`
// and words that read the texture at `at` or `uv`. See also: texel_hooks.hpp.
#pragma once

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/shader/texel_hooks.hpp>

namespace umbrage::glsl::hooks {

inline constexpr snippet gathered{.name = "lit_2x2",
                                  .summary = "lit_2x2, gathered",
                                  .needs = list<&gather_compared>,
                                  .role = hook::chosen,
                                  .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). The sampler clamps
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
)GLSL"};

inline constexpr snippet gathered_region{.name = "lit_2x2",
                                         .summary = "lit_2x2, gathered in a region",
                                         .needs = list<&gather_compared>,
                                         .role = hook::chosen,
                                         .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the nearest texel inside is compared. The gather stays inside, and each comparison is taken from its
// row and column
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = clamp(texel, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec2 high = clamp(texel + 1.0, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = high.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = high.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    return vec4(bottom.x, bottom.y, top.x, top.y);
}
)GLSL"};

inline constexpr snippet gathered_bordered{.name = "lit_2x2",
                                           .summary = "lit_2x2, gathered and bordered",
                                           .needs = list<&gather_compared, &inside_map, &compare>,
                                           .role = hook::chosen,
                                           .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The sampler's border color does not matter
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? lit.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? lit.z : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? lit.w : outside;
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet gathered_bordered_region{.name = "lit_2x2",
                                                  .summary = "lit_2x2, gathered in a bordered region",
                                                  .needs = list<&gather_compared, &inside_map, &compare>,
                                                  .role = hook::chosen,
                                                  .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
// Outside the map the far plane is compared. The gather stays inside
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = texel - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = low.x < -0.5 ? vec2(lit.x, lit.z) : vec2(lit.y, lit.w);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = low.y < -0.5 ? vec2(left.x, right.x) : vec2(left.y, right.y);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? bottom.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? top.x : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? top.y : outside;
    return vec4(a, b, c, d);
}
)GLSL"};

// The sampler weights texels. Coordinates stay half a texel inside, so that texels outside the map have no weight.

inline constexpr snippet clamped_lit_filtered{.name = "lit_filtered",
                                              .summary = "lit_filtered, clamped",
                                              .exactness = tier::c,
                                              .within = 1.0f / 128.0f,
                                              .needs = list<&within_far_plane>,
                                              .role = hook::chosen,
                                              .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
//   coord   in texels, no NaN
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
                                               .needs = list<&within_far_plane, &compare>,
                                               .role = hook::chosen,
                                               .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler. NaN is in shadow
// Outside the map the far plane is compared
//   coord   in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP vec2 inside = clamp(min(coord, size - coord) + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
)GLSL"};

// A map that fills its texture: uv over the map is what the sampler takes, and the sampler clamps to the edge.

inline constexpr snippet sampled_bordered_lit{.name = "lit_at",
                                              .summary = "lit_at, sampled and bordered",
                                              .exactness = tier::c,
                                              .within = 1.0f / 128.0f,
                                              .needs = list<&compare>,
                                              .role = hook::chosen,
                                              .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP vec2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
)GLSL"};

inline constexpr snippet sampled_bordered_depth{.name = "depth_at",
                                                .summary = "depth_at, sampled and bordered",
                                                .exactness = tier::c,
                                                .operations = 4,
                                                .needs = list<&decode>,
                                                .role = hook::chosen,
                                                .source = R"GLSL(
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, that of the far plane outside the map
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    UMBRAGE_HIGHP float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
)GLSL"};

inline constexpr snippet sampled_lit{.name = "lit_at",
                                     .summary = "lit_at, sampled",
                                     .exactness = tier::c,
                                     .within = 1.0f / 128.0f,
                                     .role = hook::chosen,
                                     .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
)GLSL"};

inline constexpr snippet planed_lit_sampled{
    .name = "lit_sampled", .summary = "lit_sampled, along a plane", .role = hook::chosen, .source = R"GLSL(
// umbrage_lit_sampled: 2x2 comparisons of the sampler around a point
UMBRAGE_HIGHP float umbrage_lit_sampled(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                        UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
)GLSL"};

inline constexpr snippet planed_lit_at{.name = "lit_at",
                                       .summary = "lit_at, along a plane",
                                       .exactness = tier::c,
                                       .within = 1.0f / 128.0f,
                                       .needs = list<&plane_reference, &planed_lit_sampled>,
                                       .role = hook::chosen,
                                       .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, with the plane's depth where the four texels
// meet
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = floor(uv * size + 0.5) - 0.5;
    return umbrage_lit_sampled(map, size, uv, UMBRAGE_CORNER);
}
)GLSL"};

inline constexpr snippet planed_bordered_lit_at{.name = "lit_at",
                                                .summary = "lit_at, bordered along a plane",
                                                .exactness = tier::c,
                                                .within = 1.0f / 128.0f,
                                                .needs = list<&plane_reference, &planed_lit_sampled>,
                                                .role = hook::chosen,
                                                .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, with the plane's depth where the four texels
// meet. Lit outside the map
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = floor(uv * size + 0.5) - 0.5;
    UMBRAGE_HIGHP float lit = umbrage_lit_sampled(map, size, uv, UMBRAGE_CORNER);
    UMBRAGE_HIGHP vec2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    return 1.0 + inside.x * inside.y * (lit - 1.0);
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
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
)GLSL"};

/// List of all hooks, for printers and packages.
inline constexpr const auto& all =
    list<&reversed_cleared_depth, &clamped_covers, &reversed_beyond_far_plane, &no_beyond_far_plane,
         &reversed_within_far_plane, &any_within_far_plane, &reversed_compare, &own_compare, &decode, &clamped_depth,
         &lit_texel, &clamped_lit, &bordered_lit, &planed_lit, &planed_lit_texel, &planed_compared_lit,
         &gather_compared, &gather_one_channel, &gather_two_channels, &gathered, &gathered_region, &gathered_bordered,
         &gathered_bordered_region, &clamped_lit_filtered, &bordered_lit_filtered, &sampled_lit, &sampled_bordered_lit,
         &planed_lit_sampled, &planed_lit_at, &planed_bordered_lit_at, &sampled_depth, &sampled_bordered_depth>;

}  // namespace umbrage::glsl::hooks
