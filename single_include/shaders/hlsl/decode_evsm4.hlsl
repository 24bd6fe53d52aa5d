// umbrage 0.1.0, decode_evsm4: mean of EVSM texels of four components to visibility. Exactness: tier C.
// decode_evsm4, tier C: within 229 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    precise float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    precise float distance = receiver - m.x;
    precise float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
#endif

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return asfloat(exponent << 23);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? min(y, 63.0) : -64.0;
    float n = floor(x);
    float f = x - n;
    precise float p = 0.00187931862 * f + 0.00899099465;
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
float umbrage_exponential_warp(float depth, float exponent) {
    precise float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM4
#define UMBRAGE_HAS_DECODE_EVSM4
// umbrage_decode_evsm4: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    precise float2 least = deviations * float2(w, n);
    precise float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
#endif
