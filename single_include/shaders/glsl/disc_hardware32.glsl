// umbrage 0.1.0, disc_hardware32: disc PCF, 32 fetches from a linear comparison sampler. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// disc_hardware32, tier C: within 1/128 of C++.
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

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE
#define UMBRAGE_HAS_WITHIN_FAR_PLANE
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COVERED
#define UMBRAGE_HAS_COVERED
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP vec2 umbrage_covered(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return vec2(1.0, 1.0);
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

#ifndef UMBRAGE_HAS_PCF_2X2
#define UMBRAGE_HAS_PCF_2X2
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                    UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    UMBRAGE_HIGHP float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_FILTERED
#define UMBRAGE_HAS_LIT_FILTERED
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2(-32767.0, -32767.0), vec2(32767.0, 32767.0)), receiver);
}
#endif

#ifndef UMBRAGE_HAS_LIT_BETWEEN
#define UMBRAGE_HAS_LIT_BETWEEN
// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
UMBRAGE_HIGHP float umbrage_lit_between(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                        UMBRAGE_HIGHP vec2 way, UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT
#define UMBRAGE_HAS_LIT_AT
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 way = floor(uv * size + 0.5) - coord;
    UMBRAGE_HIGHP vec2 inside = umbrage_covered(size, uv);
    UMBRAGE_HIGHP float lit = umbrage_lit_between(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE32
#define UMBRAGE_HAS_ELLIPSE_HARDWARE32
// umbrage_ellipse_hardware32: PCF over 32 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse_hardware32(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                               UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                               UMBRAGE_HIGHP vec2 radius, UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    UMBRAGE_HIGHP float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    UMBRAGE_HIGHP vec2 part = vec2(wide, high) * (1.0 / 1024.0) / size;
    UMBRAGE_HIGHP vec2 x = vec2(rotation.x, rotation.z) * part;
    UMBRAGE_HIGHP vec2 y = vec2(rotation.y, rotation.w) * part;
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, coord, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE32
#define UMBRAGE_HAS_DISC_HARDWARE32
// umbrage_disc_hardware32: PCF over 32 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware32(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                            UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                            UMBRAGE_HIGHP float radius, UMBRAGE_HIGHP vec4 rotation) {
    return umbrage_ellipse_hardware32(map, size, coord, receiver, vec2(radius, radius), rotation);
}
#endif
