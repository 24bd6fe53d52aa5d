// umbrage 0.1.0, disc_rotation: rotation of a disc for a pixel, one of 16. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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
