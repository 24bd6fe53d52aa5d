// umbrage 0.1.0, slope_bias: bias by the greater slope, as rasterizers have it. Exactness: tier B.
// slope_bias, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLAMP_BIAS
#define UMBRAGE_HAS_CLAMP_BIAS
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
inline float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
#endif

#ifndef UMBRAGE_HAS_SLOPE_BIAS
#define UMBRAGE_HAS_SLOPE_BIAS
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
inline float umbrage_slope_bias(float2 slope, float factor, float base) {
    float2 bias = metal::abs(slope) * factor + base;
    float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
#endif
