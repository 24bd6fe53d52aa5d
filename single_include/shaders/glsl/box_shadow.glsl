// umbrage 0.1.0, box_shadow: lit fraction of a box of radius 0..8 (box PCF). Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// box_shadow, tier B: within 290 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_BOX_SCALE
#define UMBRAGE_HAS_BOX_SCALE
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
UMBRAGE_HIGHP float umbrage_box_scale(int radius) {
    UMBRAGE_HIGHP float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
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

#ifndef UMBRAGE_HAS_BOX_COUNT_SHADOW
#define UMBRAGE_HAS_BOX_COUNT_SHADOW
// umbrage_box_count_shadow: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
UMBRAGE_HIGHP float umbrage_box_count_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                             UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 first = compared ? floor(coord) - float(r) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit_shadow(map, size, first + vec2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
#endif

#ifndef UMBRAGE_HAS_BOX_SHADOW
#define UMBRAGE_HAS_BOX_SHADOW
// umbrage_box_shadow: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count_shadow
UMBRAGE_HIGHP float umbrage_box_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                       UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver, int radius) {
    UMBRAGE_HIGHP float visibility = umbrage_box_count_shadow(map, size, coord, receiver, radius) *
        umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
#endif
