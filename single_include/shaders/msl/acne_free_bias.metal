// umbrage 0.1.0, acne_free_bias: smallest bias without acne, from slope, reach and error. Exactness: tier B.
// acne_free_bias, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CLAMP_BIAS
#define UMBRAGE_HAS_CLAMP_BIAS
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
inline float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
#endif

#ifndef UMBRAGE_HAS_ACNE_FREE_BIAS
#define UMBRAGE_HAS_ACNE_FREE_BIAS
// umbrage_acne_free_bias: smallest bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
inline float umbrage_acne_free_bias(float2 slope, float reach, float error) {
    float bias = reach * (metal::abs(slope.x) + metal::abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
#endif
