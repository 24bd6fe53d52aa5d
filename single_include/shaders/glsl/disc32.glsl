// umbrage 0.1.0, disc32: disc PCF, 32 points, rotated per pixel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DISC_RADIUS
#define UMBRAGE_HAS_DISC_RADIUS
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
UMBRAGE_HIGHP float umbrage_disc_radius(UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec4 rotation,
                                    UMBRAGE_HIGHP vec2 radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = clamp(at - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));  // no sum is regrouped across it
    UMBRAGE_HIGHP vec2 wide = vec2(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    UMBRAGE_HIGHP vec2 high = vec2(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = wide.x * p.x + within.x + wide.y * p.y;
    UMBRAGE_HIGHP float y = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(vec2(x, y));
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

#ifndef UMBRAGE_HAS_ELLIPSE32
#define UMBRAGE_HAS_ELLIPSE32
// umbrage_ellipse32: PCF over a rotated ellipse of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse32(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 radius,
                                      UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, -15.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC32
#define UMBRAGE_HAS_DISC32
// umbrage_disc32: PCF over a rotated disc of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc32(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec4 rotation) {
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse32(map, size, coord, receiver, vec2(rho, rho), rotation);
}
#endif
