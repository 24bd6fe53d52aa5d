// umbrage 0.1.0, hard_shadow: unfiltered shadow test of the nearest texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2DShadow map`, a depth texture. Its sampler passes receiver <= depth, clamps to the edge and filters
//   nearest.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, outside, direction.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
// umbrage_beyond_far_plane_shadow: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane_shadow(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
// umbrage_in_filter_domain_shadow: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain_shadow(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_shadow(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE_SHADOW
#define UMBRAGE_HAS_TEXEL_INSIDE_SHADOW
// umbrage_texel_inside_shadow: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside_shadow(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_LIT_TEXEL_SHADOW
#define UMBRAGE_HAS_LIT_TEXEL_SHADOW
// umbrage_lit_texel_shadow: the sampler's comparison with a texel inside the map. NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit_texel_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                             UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = textureLod(map, vec3((texel + 0.5) / size, receiver), 0.0);
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare_shadow(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_SHADOW
#define UMBRAGE_HAS_LIT_SHADOW
// umbrage_lit_shadow: compares the receiver with one texel. Outside the map it compares with the far plane
UMBRAGE_HIGHP float umbrage_lit_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                       UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside_shadow(size, texel);
    UMBRAGE_HIGHP float lit = umbrage_lit_texel_shadow(map, size, inside, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare_shadow(receiver, 1.0);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
#endif

#ifndef UMBRAGE_HAS_HARD_SHADOW
#define UMBRAGE_HAS_HARD_SHADOW
// umbrage_hard_shadow: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_hard_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                        UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 texel = compared ? floor(coord) : vec2(0.0, 0.0);  // no branch: fetches of several taps overlap
    UMBRAGE_HIGHP float lit = umbrage_lit_shadow(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
#endif
