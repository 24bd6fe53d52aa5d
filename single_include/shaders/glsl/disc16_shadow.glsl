// umbrage 0.1.0, disc16_shadow: disc PCF, 16 points, rotated per pixel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_ELLIPSE16_SHADOW
#define UMBRAGE_HAS_ELLIPSE16_SHADOW
// umbrage_ellipse16_shadow: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_ellipse16_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                             UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                             UMBRAGE_HIGHP vec2 radius, UMBRAGE_HIGHP vec4 rotation) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, size, umbrage_disc_tap(at, vec2(14.0, -2.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC16_SHADOW
#define UMBRAGE_HAS_DISC16_SHADOW
// umbrage_disc16_shadow: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc16_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                          UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                          UMBRAGE_HIGHP float radius, UMBRAGE_HIGHP vec4 rotation) {
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse16_shadow(map, size, coord, receiver, vec2(rho, rho), rotation);
}
#endif
