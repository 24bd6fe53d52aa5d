// umbrage 0.1.0, pcss_hardware16_shadow: percentage-closer soft shadows (PCSS) at 16 points, one texture bound to two
//   samplers. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pcss_radius, tier C: within 1/1024 of C++.
// blockers_hardware16_depths, tier C: within 24 x 2^-23 x S of the exact result.
// ellipse_hardware16_shadow, tier C: within 1/128 of C++.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `sampler2D map`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Map: `sampler2DShadow map`, a depth texture. Its sampler passes receiver <= depth, clamps to the edge and filters
//   linearly.
// Render target of the map: depth attachment, one sample. Clear to 1.0.
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

#ifndef UMBRAGE_HAS_DISC_ROTATION
#define UMBRAGE_HAS_DISC_ROTATION
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
UMBRAGE_HIGHP vec4 umbrage_disc_rotation(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    UMBRAGE_HIGHP float quarter = floor(v * 0.25);
    UMBRAGE_HIGHP float base = v - quarter * 4.0;
    UMBRAGE_HIGHP vec2 low = base < 0.5 ? vec2(64.0, 0.0) : vec2(59.0, 24.0);
    UMBRAGE_HIGHP vec2 high = base < 2.5 ? vec2(45.0, 45.0) : vec2(24.0, 59.0);
    UMBRAGE_HIGHP vec2 first = base < 1.5 ? low : high;
    UMBRAGE_HIGHP vec2 once = quarter < 0.5 ? first : vec2(0.0 - first.y, first.x);
    UMBRAGE_HIGHP vec2 twice = quarter < 2.5 ? vec2(0.0 - first.x, 0.0 - first.y) : vec2(first.y, 0.0 - first.x);
    UMBRAGE_HIGHP vec2 turned = quarter < 1.5 ? once : twice;
    return vec4(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PCSS_RADIUS
#define UMBRAGE_HAS_PCSS_RADIUS
// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
UMBRAGE_HIGHP vec2 umbrage_pcss_radius(UMBRAGE_HIGHP vec2 found, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP vec4 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    UMBRAGE_HIGHP float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    UMBRAGE_HIGHP float apart = forward ? receiver - mean : mean - receiver;
    UMBRAGE_HIGHP vec2 radius = vec2(softness.x, softness.y) * 4096.0 * apart;
    UMBRAGE_HIGHP float min_radius = softness.z * 0.0625;
    UMBRAGE_HIGHP float max_radius = softness.w * 0.0625;
    return vec2(radius.x > min_radius ? min(radius.x, max_radius) : min_radius,
                radius.y > min_radius ? min(radius.y, max_radius) : min_radius);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_DEPTHS
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_DEPTHS
// umbrage_beyond_far_plane_depths: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane_depths(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_DEPTHS
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_DEPTHS
// umbrage_in_filter_domain_depths: true if a filter compares; lit outside texel space and beyond the far plane
bool umbrage_in_filter_domain_depths(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_depths(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_DEPTHS
#define UMBRAGE_HAS_TEXEL_DEPTHS
// umbrage_texel_depths: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel_depths(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                        UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE_DEPTHS
#define UMBRAGE_HAS_TEXEL_INSIDE_DEPTHS
// umbrage_texel_inside_depths: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside_depths(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH_DEPTHS
#define UMBRAGE_HAS_FETCH_DEPTH_DEPTHS
// umbrage_fetch_depth_depths: stored depth of a texel, or the far plane's depth outside the map
UMBRAGE_HIGHP float umbrage_fetch_depth_depths(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                               UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = umbrage_texel_inside_depths(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel_depths(map, size, inside);
    UMBRAGE_HIGHP float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DEPTH_AT_DEPTHS
#define UMBRAGE_HAS_DEPTH_AT_DEPTHS
// umbrage_depth_at_depths: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_depth_at_depths(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                            UMBRAGE_HIGHP vec2 uv) {
    return umbrage_fetch_depth_depths(map, size, floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_DEPTHS
#define UMBRAGE_HAS_COMPARE_DEPTHS
// umbrage_compare_depths: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare_depths(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER_AT_DEPTHS
#define UMBRAGE_HAS_BLOCKER_AT_DEPTHS
// umbrage_blocker_at_depths: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP vec2 umbrage_blocker_at_depths(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                             UMBRAGE_HIGHP vec2 uv, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_depth_at_depths(map, size, uv);
    return umbrage_compare_depths(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, stored);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE16_DEPTHS
#define UMBRAGE_HAS_BLOCKERS_HARDWARE16_DEPTHS
// umbrage_blockers_hardware16_depths: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware16_depths(UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 size,
                                                      UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                                      UMBRAGE_HIGHP vec2 radius, UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain_depths(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    UMBRAGE_HIGHP float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    UMBRAGE_HIGHP vec2 part = vec2(wide, high) * (1.0 / 1024.0) / size;
    UMBRAGE_HIGHP vec2 x = vec2(rotation.x, rotation.z) * part;
    UMBRAGE_HIGHP vec2 y = vec2(rotation.y, rotation.w) * part;
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker_at_depths(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : vec2(0.0, 0.0);
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
