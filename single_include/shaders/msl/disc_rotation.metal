// umbrage 0.1.0, disc_rotation: rotation of a disc for a pixel, one of 16. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_DISC_ROTATION
#define UMBRAGE_HAS_DISC_ROTATION
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, sin) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
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
