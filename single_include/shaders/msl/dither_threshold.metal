// umbrage 0.1.0, dither_threshold: one of 16 dither thresholds for a pixel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
inline bool umbrage_inside_texel_space(float2 coord) {
    // two different limits: of one limit Mesa makes max(x, y) < limit, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_DITHER_THRESHOLD
#define UMBRAGE_HAS_DITHER_THRESHOLD
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
inline float umbrage_dither_threshold(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float2 high = metal::floor(whole * 0.5);
    float2 above = metal::floor(whole * 0.25);
    float2 b0 = whole - high * 2.0;
    float2 b1 = high - above * 2.0;
    float m = metal::abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + metal::abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
#endif
