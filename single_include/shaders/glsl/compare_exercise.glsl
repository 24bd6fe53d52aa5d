// umbrage 0.1.0, compare_exercise: lit if current < stored + epsilon. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// compare_exercise, tier B: within 1 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_COMPARE_EXERCISE
#define UMBRAGE_HAS_COMPARE_EXERCISE
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
UMBRAGE_HIGHP float umbrage_compare_exercise(UMBRAGE_HIGHP float current, UMBRAGE_HIGHP float stored,
                                             UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
#endif
