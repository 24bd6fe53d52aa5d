// umbrage 0.1.0, decode_deviation: mean and deviation to two moments of depth (VSM). Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// decode_deviation, tier B: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DECODE_DEVIATION
#define UMBRAGE_HAS_DECODE_DEVIATION
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation(UMBRAGE_HIGHP vec2 held) {
    UMBRAGE_HIGHP float half_of_it = held.y * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = held.x * held.x + half_of_it * half_of_it;
    return vec2(held.x, square);
}
#endif
