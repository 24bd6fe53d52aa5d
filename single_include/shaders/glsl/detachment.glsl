// umbrage 0.1.0, detachment: depth before a receiver within which its bias loses a caster's shadow. Exactness: tier
//   B.
// Tier B: GLSL below 400 and 320 es lets compilers fuse or reorder sums. Results then stay within the stated bound.
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
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
#endif

#ifndef UMBRAGE_HAS_ACNE_FREE_BIAS
#define UMBRAGE_HAS_ACNE_FREE_BIAS
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
UMBRAGE_HIGHP float umbrage_acne_free_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float reach,
                                           UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias =
        reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
#endif

#ifndef UMBRAGE_HAS_DETACHMENT
#define UMBRAGE_HAS_DETACHMENT
// umbrage_detachment: depth before a receiver within which a caster's shadow is lost, wholly or in part, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
UMBRAGE_HIGHP float umbrage_detachment(UMBRAGE_HIGHP float bias, UMBRAGE_HIGHP vec2 caster_slope,
                                       UMBRAGE_HIGHP float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
#endif
