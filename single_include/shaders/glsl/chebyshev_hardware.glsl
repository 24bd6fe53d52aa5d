// umbrage 0.1.0, chebyshev_hardware: Chebyshev bound with light bleeding reduced. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// chebyshev_hardware, tier C: within 1/524288 of C++.
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

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_chebyshev_hardware(UMBRAGE_HIGHP float variance, UMBRAGE_HIGHP float distance,
                                               UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float beyond = max(distance, 0.0);
    UMBRAGE_HIGHP float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
#endif
