// umbrage 0.1.0, pcf_2x2_hardware_shadow: bilinear 2x2 PCF by a linear comparison sampler. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// pcf_2x2_hardware_shadow, tier C: within 1/128 of C++.
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
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
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

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare_shadow(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT_SHADOW
#define UMBRAGE_HAS_LIT_AT_SHADOW
// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted by the sampler, with the far plane outside the map
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
UMBRAGE_HIGHP float umbrage_lit_at_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                          UMBRAGE_HIGHP vec2 uv, UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = textureLod(map, vec3(uv, receiver), 0.0);
    UMBRAGE_HIGHP float outside = umbrage_compare_shadow(receiver, 1.0);
    UMBRAGE_HIGHP vec2 inside = clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, vec2(0.0, 0.0), vec2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_HARDWARE_SHADOW
#define UMBRAGE_HAS_PCF_2X2_HARDWARE_SHADOW
// umbrage_pcf_2x2_hardware_shadow: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                                    UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_at_shadow(map, size, at / size, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane_shadow(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
#endif
