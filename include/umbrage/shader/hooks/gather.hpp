// SPDX-License-Identifier: MIT
//
// Hooks for maps whose sampler gathers four texels at a time: texel + (0, 0), (1, 0), (0, 1) and (1, 1), in this order.
// Four steps are chosen separately: the texels of one gather, the region of the texture, the comparison, and the texels
// outside. See also: fetch.hpp, which explains the words.
//
#pragma once

#include <umbrage/shader/hooks/fetch.hpp>

namespace umbrage::glsl::hooks {

// One gather reads four texels, as comparisons or as depths. Languages return those at (0, 1), (1, 1), (1, 0) and
// (0, 0), in this order; these functions put them into the order above.

inline constexpr snippet gather_compared{
    .name = "gather", .summary = "gather, compared", .role = hook::gather, .source = R"GLSL(
// umbrage_gather: the sampler's comparisons with four texels. NaN is in shadow
UMBRAGE_HIGHP vec4 umbrage_gather(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                  UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 lit = UMBRAGE_GATHER_LIT;
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return vec4(lit.w, lit.z, lit.x, lit.y) * number;
}
)GLSL"};

inline constexpr snippet gather_one_channel{
    .name = "gather", .summary = "gather, one channel", .needs = list<&decode>, .role = hook::chosen, .source = R"GLSL(
// umbrage_gather: depths of four texels
UMBRAGE_HIGHP vec4 umbrage_gather(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                  UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP float a = umbrage_decode(vec4(r.w, 0.0, 0.0, 0.0));
    UMBRAGE_HIGHP float b = umbrage_decode(vec4(r.z, 0.0, 0.0, 0.0));
    UMBRAGE_HIGHP float c = umbrage_decode(vec4(r.x, 0.0, 0.0, 0.0));
    UMBRAGE_HIGHP float d = umbrage_decode(vec4(r.y, 0.0, 0.0, 0.0));
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet gather_two_channels{
    .name = "gather", .summary = "gather, two channels", .needs = list<&decode>, .role = hook::chosen, .source = R"GLSL(
// umbrage_gather: depths of four texels
UMBRAGE_HIGHP vec4 umbrage_gather(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                  UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP vec4 g = UMBRAGE_GATHER_GREEN;
    UMBRAGE_HIGHP float a = umbrage_decode(vec4(r.w, g.w, 0.0, 0.0));
    UMBRAGE_HIGHP float b = umbrage_decode(vec4(r.z, g.z, 0.0, 0.0));
    UMBRAGE_HIGHP float c = umbrage_decode(vec4(r.x, g.x, 0.0, 0.0));
    UMBRAGE_HIGHP float d = umbrage_decode(vec4(r.y, g.y, 0.0, 0.0));
    return vec4(a, b, c, d);
}
)GLSL"};

// A sampler clamps to the edge of its texture. A map that is a region of one is clamped here.

inline constexpr snippet gather_clamped{.name = "gather_clamped",
                                        .summary = "gather_clamped, by the sampler",
                                        .needs = list<&gather_compared>,
                                        .role = hook::gather_clamped,
                                        .source = R"GLSL(
// umbrage_gather_clamped: umbrage_gather. The sampler clamps to the edge
UMBRAGE_HIGHP vec4 umbrage_gather_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP float receiver) {
    return umbrage_gather(map, size, texel, receiver);
}
)GLSL"};

inline constexpr snippet gather_in_region{.name = "gather_clamped",
                                          .summary = "gather_clamped, in a region",
                                          .needs = list<&gather_compared>,
                                          .role = hook::chosen,
                                          .source = R"GLSL(
// umbrage_gather_clamped: umbrage_gather of the nearest texels inside the region. It gathers inside, and takes each
// value from its row and column
UMBRAGE_HIGHP vec4 umbrage_gather_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = clamp(texel, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec2 high = clamp(texel + 1.0, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec4 four = umbrage_gather(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(four.y, four.w) : vec2(four.x, four.z);
    UMBRAGE_HIGHP vec2 right = high.x > 0.5 ? vec2(four.y, four.w) : vec2(four.x, four.z);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = high.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    return vec4(bottom.x, bottom.y, top.x, top.y);
}
)GLSL"};

// The receiver is compared with four depths, unless the sampler did so.

inline constexpr snippet gather_lit{.name = "gather_lit",
                                    .summary = "gather_lit, compared by the sampler",
                                    .needs = list<&gather_clamped>,
                                    .role = hook::gather_lit,
                                    .source = R"GLSL(
// umbrage_gather_lit: visibility of four comparisons, with the nearest texel inside where one is outside
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_clamped(map, size, texel, receiver);
}
)GLSL"};

inline constexpr snippet gathered_lit{.name = "gather_lit",
                                      .summary = "gather_lit, of depths",
                                      .needs = list<&gather_clamped, &compare>,
                                      .role = hook::chosen,
                                      .source = R"GLSL(
// umbrage_gather_lit: visibility of four comparisons, with the nearest texel inside where one is outside
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec4 stored = umbrage_gather_clamped(map, size, texel, receiver);
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, stored.x);
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, stored.y);
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, stored.z);
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, stored.w);
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet planed_compare{.name = "compare_along",
                                        .summary = "compare_along, along a plane",
                                        .needs = list<&texel_inside, &compare>,
                                        .role = hook::chosen,
                                        .source = R"GLSL(
// umbrage_compare_along: visibility of one comparison with a texel's depth, along the receiver's plane
UMBRAGE_HIGHP float umbrage_compare_along(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP float stored) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    return umbrage_compare(UMBRAGE_REFERENCE, stored);
}
)GLSL"};

inline constexpr snippet planed_gathered_lit{.name = "gather_lit",
                                             .summary = "gather_lit, along a plane",
                                             .needs = list<&gather_clamped, &planed_compare>,
                                             .role = hook::chosen,
                                             .source = R"GLSL(
// umbrage_gather_lit: visibility of four comparisons, along the receiver's plane
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec4 stored = umbrage_gather_clamped(map, size, texel, receiver);
    UMBRAGE_HIGHP float a = umbrage_compare_along(map, size, texel, stored.x);
    UMBRAGE_HIGHP float b = umbrage_compare_along(map, size, texel + vec2(1.0, 0.0), stored.y);
    UMBRAGE_HIGHP float c = umbrage_compare_along(map, size, texel + vec2(0.0, 1.0), stored.z);
    UMBRAGE_HIGHP float d = umbrage_compare_along(map, size, texel + vec2(1.0, 1.0), stored.w);
    return vec4(a, b, c, d);
}
)GLSL"};

// Texels outside the map count as its border. Along a plane the depth that they are compared with lights them already.

inline constexpr snippet gathered{.name = "lit_2x2",
                                  .summary = "lit_2x2, gathered",
                                  .needs = list<&gather_lit>,
                                  .role = hook::chosen,
                                  .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
)GLSL"};

inline constexpr snippet gathered_bordered{.name = "lit_2x2",
                                           .summary = "lit_2x2, gathered and bordered",
                                           .needs = list<&gather_lit, &inside_map, &compare>,
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

}  // namespace umbrage::glsl::hooks
