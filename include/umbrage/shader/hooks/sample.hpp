// SPDX-License-Identifier: MIT
//
// Hooks for maps whose sampler reads between texels, or compares. See also: fetch.hpp, which explains the words.
//
#pragma once

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/shader/hooks/fetch.hpp>

namespace umbrage::glsl::hooks {

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

// A map's own sampler clamps to the edge, so texels outside the map are counted apart.

inline constexpr snippet bordered_covered{.name = "covered",
                                          .summary = "covered, bordered",
                                          .exactness = tier::c,
                                          .operations = 6,
                                          .role = hook::chosen,
                                          .source = R"GLSL(
// umbrage_covered: share of the texels around a point that lie in the map, along each axis
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP vec2 umbrage_covered(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2(0.0, 0.0), vec2(1.0, 1.0));
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

inline constexpr snippet sampled_lit{.name = "lit_between",
                                     .summary = "lit_between, sampled",
                                     .exactness = tier::c,
                                     .within = 1.0f / 128.0f,
                                     .role = hook::chosen,
                                     .source = R"GLSL(
// umbrage_lit_between: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_between(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                        UMBRAGE_HIGHP vec2 way, UMBRAGE_HIGHP float receiver) {
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

inline constexpr snippet planed_lit_between{.name = "lit_between",
                                            .summary = "lit_between, along a plane",
                                            .exactness = tier::c,
                                            .within = 1.0f / 128.0f,
                                            .needs = list<&corner_reference, &planed_lit_sampled>,
                                            .role = hook::chosen,
                                            .source = R"GLSL(
// umbrage_lit_between: 2x2 comparisons around a point, weighted by the sampler, with the plane's depth where the four
// texels meet
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0)
//   way   from the receiver to where the four texels meet, in texels
UMBRAGE_HIGHP float umbrage_lit_between(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                        UMBRAGE_HIGHP vec2 way, UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_sampled(map, size, uv, UMBRAGE_CORNER);
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

}  // namespace umbrage::glsl::hooks
