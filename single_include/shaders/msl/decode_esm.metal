// umbrage 0.1.0, decode_esm: mean of ESM texels to visibility. Exactness: tier B.
// decode_esm, tier B: within 37 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
inline float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return as_type<float>(exponent << 23);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
inline float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? metal::min(y, 63.0) : -64.0;
    float n = metal::floor(x);
    float f = x - n;
    float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
#endif

#ifndef UMBRAGE_HAS_EXPONENTIAL_WARP
#define UMBRAGE_HAS_EXPONENTIAL_WARP
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
inline float umbrage_exponential_warp(float depth, float exponent) {
    float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_ESM
#define UMBRAGE_HAS_DECODE_ESM
// umbrage_decode_esm: visibility of a receiver from an exponential shadow map, at least its lit fraction. 1.0 = lit
//   m          mean of texels
//   receiver   receiver depth, bias applied
//   exponent   same as for the texels
inline float umbrage_decode_esm(float m, float receiver, float exponent) {
    float d = umbrage_to_forward_depth(receiver);
    float p = m * umbrage_exponential_warp(d, -exponent);
    float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif
