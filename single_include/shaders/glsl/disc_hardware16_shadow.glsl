// umbrage 0.1.0, disc_hardware16_shadow: disc PCF, 16 fetches from a linear comparison sampler. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// disc_hardware16_shadow, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2DShadow map`, a depth texture. Its sampler passes receiver <= depth, clamps to the edge and filters
//   linearly.
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

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
// umbrage_within_far_plane_shadow: true if a receiver is a number and not beyond the far plane
bool umbrage_within_far_plane_shadow(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COVERED_SHADOW
#define UMBRAGE_HAS_COVERED_SHADOW
// umbrage_covered_shadow: share of the texels around a point that lie in the map, along each axis
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP vec2 umbrage_covered_shadow(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2(0.0, 0.0), vec2(1.0, 1.0));
}
#endif

#ifndef UMBRAGE_HAS_LIT_BETWEEN_SHADOW
#define UMBRAGE_HAS_LIT_BETWEEN_SHADOW
// umbrage_lit_between_shadow: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_between_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                               UMBRAGE_HIGHP vec2 uv, UMBRAGE_HIGHP vec2 way,
                                               UMBRAGE_HIGHP float receiver) {
    return textureLod(map, vec3(uv, receiver), 0.0);
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT_SHADOW
#define UMBRAGE_HAS_LIT_AT_SHADOW
// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
UMBRAGE_HIGHP float umbrage_lit_at_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                          UMBRAGE_HIGHP vec2 uv, UMBRAGE_HIGHP vec2 coord,
                                          UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 way = floor(uv * size + 0.5) - coord;
    UMBRAGE_HIGHP vec2 inside = umbrage_covered_shadow(size, uv);
    UMBRAGE_HIGHP float lit = umbrage_lit_between_shadow(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE16_SHADOW
#define UMBRAGE_HAS_ELLIPSE_HARDWARE16_SHADOW
// umbrage_ellipse_hardware16_shadow: PCF over 16 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse_hardware16_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                                      UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                                      UMBRAGE_HIGHP vec2 radius, UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    UMBRAGE_HIGHP float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    UMBRAGE_HIGHP vec2 part = vec2(wide, high) * (1.0 / 1024.0) / size;
    UMBRAGE_HIGHP vec2 x = vec2(rotation.x, rotation.z) * part;
    UMBRAGE_HIGHP vec2 y = vec2(rotation.y, rotation.w) * part;
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_at_shadow(map, size, center + x * 1.0 - y * 3.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 0.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 6.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 8.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 0.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 11.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 12.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 1.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 9.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 13.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center - x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane_shadow(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
#define UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
// umbrage_disc_hardware16_shadow: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware16_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                                   UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                                   UMBRAGE_HIGHP float radius, UMBRAGE_HIGHP vec4 rotation) {
    return umbrage_ellipse_hardware16_shadow(map, size, coord, receiver, vec2(radius, radius), rotation);
}
#endif
