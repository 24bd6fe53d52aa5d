// umbrage 0.1.0, four_tap_hardware: mean of four taps from a nearest-texel sampler. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// four_tap_hardware, tier C: within 39 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
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

#ifndef UMBRAGE_HAS_DEPTH_AT
#define UMBRAGE_HAS_DEPTH_AT
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_FOUR_TAP_HARDWARE
#define UMBRAGE_HAS_FOUR_TAP_HARDWARE
// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_four_tap_hardware(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                              UMBRAGE_HIGHP vec2 a, UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c,
                                              UMBRAGE_HIGHP vec2 d, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    UMBRAGE_HIGHP float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
#endif
