// SPDX-License-Identifier: MIT
//
// Hooks for each kind of map, of its depths and of single texels. `bind()` puts one of these functions in place of a
// hook's own text, which is that of a plain map. The map fills in these words:
//   UMBRAGE_MAP map   its parameters
//   UMBRAGE_ORIGIN    its first texel in the texture
//   UMBRAGE_DEPTH     the depth of a `value`, or the far plane's where the receiver's plane is lit
//   UMBRAGE_STORED    the depth of a `value`
//   UMBRAGE_REFERENCE the depth of the receiver's plane that a `texel` is compared with
//   UMBRAGE_CORNER    the same where four texels meet, a `way` from the receiver
//   UMBRAGE_BORDER    the depth outside
//   UMBRAGE_COMPARE   a user's own comparison
//   UMBRAGE_UV        texture coordinates for `at`
// and words that read the texture at `at` or `uv`. See also: gather.hpp, sample.hpp.
#pragma once

#include <umbrage/core/texel_space.hpp>

namespace umbrage::glsl::hooks {

inline constexpr snippet reversed_cleared_depth{
    .name = "cleared_depth", .summary = "cleared_depth, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 0.0;
}
)GLSL"};

inline constexpr snippet clamped_covers{
    .name = "map_covers", .summary = "map_covers, clamped", .role = hook::chosen, .source = R"GLSL(
// umbrage_map_covers: always true, as the nearest texel inside is used outside the map
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return true;
}
)GLSL"};

inline constexpr snippet clamped_texel_inside{
    .name = "texel_inside", .summary = "texel_inside, clamped", .role = hook::chosen, .source = R"GLSL(
// umbrage_texel_inside: texel of the map, or the nearest one for coordinates outside
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return clamp(texel, vec2(0.0, 0.0), size - 1.0);
}
)GLSL"};

inline constexpr snippet reversed_beyond_far_plane{
    .name = "beyond_far_plane", .summary = "beyond_far_plane, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_beyond_far_plane: true when a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver < 0.0;
}
)GLSL"};

inline constexpr snippet no_beyond_far_plane{
    .name = "beyond_far_plane", .summary = "beyond_far_plane, without", .role = hook::chosen, .source = R"GLSL(
// umbrage_beyond_far_plane: always false for this map. Receivers beyond the far plane have a value that every texel
// lights
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return false;
}
)GLSL"};

inline constexpr snippet any_within_far_plane{
    .name = "within_far_plane", .summary = "within_far_plane, without", .role = hook::chosen, .source = R"GLSL(
// umbrage_within_far_plane: true when a receiver is a number, as no receiver of this map is beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    // a sum of choices: compilers take an or of the comparisons for true
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
)GLSL"};

inline constexpr snippet reversed_within_far_plane{
    .name = "within_far_plane", .summary = "within_far_plane, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_within_far_plane: true when a receiver is a number and not beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver >= 0.0;
}
)GLSL"};

inline constexpr snippet reversed_compare{
    .name = "compare", .summary = "compare, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth. Near is 1.0
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
)GLSL"};

inline constexpr snippet own_compare{
    .name = "compare", .summary = "compare, own", .role = hook::chosen, .source = R"GLSL(
// umbrage_compare: visibility of one comparison, by the map's own comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_COMPARE;
}
)GLSL"};

inline constexpr snippet decode{.name = "decode", .summary = "decode", .role = hook::chosen, .source = R"GLSL(
// umbrage_decode: depth of a value that the sampler returned
UMBRAGE_HIGHP float umbrage_decode(UMBRAGE_HIGHP vec4 value) {
    return UMBRAGE_STORED;
}
)GLSL"};

inline constexpr snippet clamped_depth{.name = "fetch_depth",
                                       .summary = "fetch_depth, clamped",
                                       .needs = list<&fetch_clamped>,
                                       .role = hook::chosen,
                                       .source = R"GLSL(
// umbrage_fetch_depth: stored depth of a texel, that of the nearest texel inside when outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
)GLSL"};

inline constexpr snippet lit_texel{.name = "lit_texel", .summary = "lit_texel", .role = hook::chosen, .source = R"GLSL(
// umbrage_lit_texel: the sampler's comparison with a texel inside the map. NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
)GLSL"};

inline constexpr snippet clamped_lit{
    .name = "lit", .summary = "lit, clamped", .needs = list<&lit_texel>, .role = hook::chosen, .source = R"GLSL(
// umbrage_lit: visibility of one comparison with a texel, with the nearest texel inside when outside the map
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0), receiver);
}
)GLSL"};

inline constexpr snippet bordered_lit{.name = "lit",
                                      .summary = "lit, bordered",
                                      .needs = list<&texel_inside, &lit_texel, &compare>,
                                      .role = hook::chosen,
                                      .source = R"GLSL(
// umbrage_lit: compares the receiver with one texel. Outside the map it compares with the far plane
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP float lit = umbrage_lit_texel(map, size, inside, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
)GLSL"};

// Along the receiver's plane the border lies before every stored depth, so that it needs no comparison of its own.

inline constexpr snippet planed_lit{.name = "lit",
                                    .summary = "lit, along a plane",
                                    .needs = list<&texel, &texel_inside, &compare>,
                                    .role = hook::chosen,
                                    .source = R"GLSL(
// umbrage_lit: visibility from one comparison with a texel, along the receiver's plane
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    return umbrage_compare(UMBRAGE_REFERENCE, UMBRAGE_STORED);
}
)GLSL"};

inline constexpr snippet planed_lit_texel{
    .name = "lit_texel", .summary = "lit_texel, along a plane", .role = hook::chosen, .source = R"GLSL(
// umbrage_lit_texel: the sampler's comparison with a texel inside the map
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_LIT_TEXEL;
}
)GLSL"};

inline constexpr snippet planed_compared_lit{.name = "lit",
                                             .summary = "lit, compared along a plane",
                                             .needs = list<&texel_inside, &planed_lit_texel>,
                                             .role = hook::chosen,
                                             .source = R"GLSL(
// umbrage_lit: visibility of one comparison with a texel, along the receiver's plane. NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP float lit = umbrage_lit_texel(map, size, inside, UMBRAGE_REFERENCE);
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return lit * number;
}
)GLSL"};

}  // namespace umbrage::glsl::hooks
