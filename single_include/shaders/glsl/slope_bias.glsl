// umbrage 0.1.0, slope_bias: slope-scaled bias, as rasterizers compute it. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// slope_bias, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
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

#ifndef UMBRAGE_HAS_CLAMP_BIAS
#define UMBRAGE_HAS_CLAMP_BIAS
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias < 1.0 ? (bias >= least ? bias : 0.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SLOPE_BIAS
#define UMBRAGE_HAS_SLOPE_BIAS
// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
UMBRAGE_HIGHP float umbrage_slope_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float factor,
                                       UMBRAGE_HIGHP float base) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 bias = abs(slope) * factor + base;
    UMBRAGE_HIGHP float x = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    UMBRAGE_HIGHP float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
#endif
