// SPDX-License-Identifier: MIT
//
// Hooks for maps whose sampler gathers four texels at a time. See also: fetch.hpp, which explains the words.
//
#pragma once

#include <umbrage/shader/hooks/fetch.hpp>

namespace umbrage::glsl::hooks {

inline constexpr snippet gather_compared{
    .name = "gather_lit", .summary = "gather_lit, compared", .role = hook::gather_lit, .source = R"GLSL(
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1). NaN is in shadow
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 lit = UMBRAGE_GATHER_LIT;
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return vec4(lit.w, lit.z, lit.x, lit.y) * number;
}
)GLSL"};

inline constexpr snippet gather_one_channel{.name = "gather_lit",
                                            .summary = "gather_lit, one channel",
                                            .needs = list<&decode, &compare>,
                                            .role = hook::chosen,
                                            .source = R"GLSL(
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, 0.0, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet gather_two_channels{.name = "gather_lit",
                                             .summary = "gather_lit, two channels",
                                             .needs = list<&decode, &compare>,
                                             .role = hook::chosen,
                                             .source = R"GLSL(
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP vec4 g = UMBRAGE_GATHER_GREEN;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, g.w, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, g.z, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, g.x, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, g.y, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
)GLSL"};

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

}  // namespace umbrage::glsl::hooks
