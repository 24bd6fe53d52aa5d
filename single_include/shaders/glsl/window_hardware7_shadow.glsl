// umbrage 0.1.0, window_hardware7_shadow: 7x7 kernel, 16 fetches from a linear comparison sampler. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// window_hardware7_shadow, tier C: within 1/128 of C++.
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

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE7_SHADOW
#define UMBRAGE_HAS_WINDOW_HARDWARE7_SHADOW
// umbrage_window_hardware7_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware7_shadow(UMBRAGE_HIGHP sampler2DShadow map, UMBRAGE_HIGHP vec2 size,
                                                    UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver,
                                                    UMBRAGE_HIGHP float k0, UMBRAGE_HIGHP float k1,
                                                    UMBRAGE_HIGHP float k2, UMBRAGE_HIGHP float k3) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    UMBRAGE_HIGHP vec2 w0 = k0 + k1 + s * -k1;
    UMBRAGE_HIGHP vec2 p0 = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    UMBRAGE_HIGHP vec2 v0 = w0 * umbrage_covered_shadow(size, p0);
    UMBRAGE_HIGHP vec2 w1 = k2 + k3 + s * (k1 - k3);
    UMBRAGE_HIGHP vec2 p1 = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    UMBRAGE_HIGHP vec2 v1 = w1 * umbrage_covered_shadow(size, p1);
    UMBRAGE_HIGHP vec2 w2 = k1 + k2 + s * (-k1 + k3);
    UMBRAGE_HIGHP vec2 p2 = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    UMBRAGE_HIGHP vec2 v2 = w2 * umbrage_covered_shadow(size, p2);
    UMBRAGE_HIGHP vec2 w3 = k0 + s * k1;
    UMBRAGE_HIGHP vec2 p3 = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    UMBRAGE_HIGHP vec2 v3 = w3 * umbrage_covered_shadow(size, p3);
    UMBRAGE_HIGHP vec2 inside = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP float row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, size, vec2(p0.x, p0.y), vec2(-2.5, -2.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, size, vec2(p1.x, p0.y), vec2(-0.5, -2.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, size, vec2(p2.x, p0.y), vec2(1.5, -2.5) - s, receiver);
    row += v3.x * umbrage_lit_between_shadow(map, size, vec2(p3.x, p0.y), vec2(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, size, vec2(p0.x, p1.y), vec2(-2.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, size, vec2(p1.x, p1.y), vec2(-0.5, -0.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, size, vec2(p2.x, p1.y), vec2(1.5, -0.5) - s, receiver);
    row += v3.x * umbrage_lit_between_shadow(map, size, vec2(p3.x, p1.y), vec2(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, size, vec2(p0.x, p2.y), vec2(-2.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, size, vec2(p1.x, p2.y), vec2(-0.5, 1.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, size, vec2(p2.x, p2.y), vec2(1.5, 1.5) - s, receiver);
    row += v3.x * umbrage_lit_between_shadow(map, size, vec2(p3.x, p2.y), vec2(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between_shadow(map, size, vec2(p0.x, p3.y), vec2(-2.5, 3.5) - s, receiver);
    row += v1.x * umbrage_lit_between_shadow(map, size, vec2(p1.x, p3.y), vec2(-0.5, 3.5) - s, receiver);
    row += v2.x * umbrage_lit_between_shadow(map, size, vec2(p2.x, p3.y), vec2(1.5, 3.5) - s, receiver);
    row += v3.x * umbrage_lit_between_shadow(map, size, vec2(p3.x, p3.y), vec2(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane_shadow(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif
