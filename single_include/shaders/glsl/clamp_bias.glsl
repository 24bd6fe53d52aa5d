// umbrage 0.1.0, clamp_bias: clamp of a bias to [0, 1]; NaN becomes 1. Exactness: tier A.
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
