// umbrage 0.1.0, binomial5: PCF kernel 1 4 6 4 1. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Other maps: bind() of the library or of its npm package prints this text, by texture, depth, outside, compare,
//   direction.

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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE
#define UMBRAGE_HAS_TEXEL_INSIDE
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                        UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    UMBRAGE_HIGHP float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2
#define UMBRAGE_HAS_LIT_2X2
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float a = umbrage_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float b = umbrage_lit(map, size, texel + vec2(1.0, 0.0), receiver);
    UMBRAGE_HIGHP float c = umbrage_lit(map, size, texel + vec2(0.0, 1.0), receiver);
    UMBRAGE_HIGHP float d = umbrage_lit(map, size, texel + vec2(1.0, 1.0), receiver);
    return vec4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM5
#define UMBRAGE_HAS_WINDOW_SUM5
// umbrage_window_sum5: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
UMBRAGE_HIGHP float umbrage_window_sum5(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1, UMBRAGE_HIGHP float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0 + k1 + k2 + k1 + k0);
    UMBRAGE_HIGHP vec2 w0 = floor(r * k0);
    UMBRAGE_HIGHP vec2 w1 = floor(r * k1 + s * k0);
    UMBRAGE_HIGHP vec2 w3 = floor(r * k1 + s * k2);
    UMBRAGE_HIGHP vec2 w4 = floor(r * k0 + s * k1);
    UMBRAGE_HIGHP vec2 w5 = floor(s * k0);
    UMBRAGE_HIGHP vec2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 first = texel - 2.0;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, first + vec2(0.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, first + vec2(2.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, first + vec2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_BINOMIAL5
#define UMBRAGE_HAS_BINOMIAL5
// umbrage_binomial5: PCF under 5 x 5 weights, 1 4 6 4 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_binomial5(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif
