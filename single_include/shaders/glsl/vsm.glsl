// umbrage 0.1.0, vsm: visibility from a blurred variance shadow map (VSM). Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// vsm, tier C: within 165 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, texels of the kind that the function's comment names, read unfiltered.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
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

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
UMBRAGE_HIGHP float umbrage_chebyshev(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                      UMBRAGE_HIGHP float min_variance) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float difference = m.y - m.x * m.x;
    UMBRAGE_HIGHP float variance = difference > min_variance ? difference : min_variance;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float distance = receiver - m.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = variance + distance * distance;
    UMBRAGE_HIGHP float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
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

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
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

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
UMBRAGE_HIGHP vec4 umbrage_fetch_bilinear(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                          UMBRAGE_HIGHP vec2 coord) {
    UMBRAGE_HIGHP vec2 x = floor(coord * 256.0) - 128.0;
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, texel);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 low = a * lo.x + b * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 high = c * lo.x + d * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_VSM
#define UMBRAGE_HAS_DECODE_VSM
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
#endif

#ifndef UMBRAGE_HAS_VSM
#define UMBRAGE_HAS_VSM
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
UMBRAGE_HIGHP float umbrage_vsm(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_vsm(vec2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
#endif
