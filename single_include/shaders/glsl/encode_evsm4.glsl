// umbrage 0.1.0, encode_evsm4: depth to an EVSM texel of four components. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// encode_evsm4, tier B: within 73 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of evsm4: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_evsm4 of the far
//   plane's depth.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
UMBRAGE_HIGHP float umbrage_power_of_two(UMBRAGE_HIGHP float n) {
#if __VERSION__ >= 300
    UMBRAGE_HIGHP uint exponent = uint(n + 127.0);
    return uintBitsToFloat(exponent << 23);
#else
    UMBRAGE_HIGHP float x = n < 0.0 ? n + 64.0 : n;
    UMBRAGE_HIGHP float p = 1.0;
    p = n < 0.0 ? p * (1.0 / 4294967296.0) * (1.0 / 4294967296.0) : p;
    p = x >= 32.0 ? p * 4294967296.0 : p;
    x = x >= 32.0 ? x - 32.0 : x;
    p = x >= 16.0 ? p * 65536.0 : p;
    x = x >= 16.0 ? x - 16.0 : x;
    p = x >= 8.0 ? p * 256.0 : p;
    x = x >= 8.0 ? x - 8.0 : x;
    p = x >= 4.0 ? p * 16.0 : p;
    x = x >= 4.0 ? x - 4.0 : x;
    p = x >= 2.0 ? p * 4.0 : p;
    x = x >= 2.0 ? x - 2.0 : x;
    return x >= 1.0 ? p * 2.0 : p;
#endif
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
UMBRAGE_HIGHP float umbrage_exp2_polynomial(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = y > -64.0 ? min(y, 63.0) : -64.0;
    UMBRAGE_HIGHP float n = floor(x);
    UMBRAGE_HIGHP float f = x - n;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = 0.00187931862 * f + 0.00899099465;
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
UMBRAGE_HIGHP float umbrage_exponential_warp(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_EVSM4
#define UMBRAGE_HAS_ENCODE_EVSM4
// umbrage_encode_evsm4: texel of four components, a growing power, its square, a negative falling power, its square
// NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_evsm4(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec2 exponents) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_exponential_warp(d, -exponents.y);
    return vec4(w, w * w, n, n * n);
}
#endif
