// umbrage 0.1.0, dither_threshold: one of 16 thresholds for a pixel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
inline bool umbrage_inside_texel_space(float2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_DITHER_THRESHOLD
#define UMBRAGE_HAS_DITHER_THRESHOLD
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
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
