// umbrage 0.1.0, disc_rotation: one of 16 turns for a pixel. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DISC_ROTATION
#define UMBRAGE_HAS_DISC_ROTATION
// umbrage_disc_rotation: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
inline float2 umbrage_disc_rotation(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float v = whole.x * 4.0 + whole.y;
    v = v - metal::floor(v * (1.0 / 16.0)) * 16.0;
    float quarter = metal::floor(v * 0.25);
    float base = v - quarter * 4.0;
    float2 low = base < 0.5 ? float2(64.0, 0.0) : float2(59.0, 24.0);
    float2 high = base < 2.5 ? float2(45.0, 45.0) : float2(24.0, 59.0);
    float2 first = base < 1.5 ? low : high;
    float2 once = quarter < 0.5 ? first : float2(0.0 - first.y, first.x);
    float2 twice = quarter < 2.5 ? float2(0.0 - first.x, 0.0 - first.y) : float2(first.y, 0.0 - first.x);
    return quarter < 1.5 ? once : twice;
}
#endif
