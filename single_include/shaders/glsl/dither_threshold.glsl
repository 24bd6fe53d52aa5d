// umbrage 0.1.0, dither_threshold: one of 16 dither thresholds for a pixel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DITHER_THRESHOLD
#define UMBRAGE_HAS_DITHER_THRESHOLD
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
UMBRAGE_HIGHP float umbrage_dither_threshold(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 high = floor(whole * 0.5);
    UMBRAGE_HIGHP vec2 above = floor(whole * 0.25);
    UMBRAGE_HIGHP vec2 b0 = whole - high * 2.0;
    UMBRAGE_HIGHP vec2 b1 = high - above * 2.0;
    UMBRAGE_HIGHP float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
#endif
