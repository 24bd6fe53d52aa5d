// umbrage 0.1.0, from_optimized_moments: four 16-bit channels to four moments (MSM). Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// from_optimized_moments, tier B: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
UMBRAGE_HIGHP vec4 umbrage_from_optimized_moments(UMBRAGE_HIGHP vec4 o) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = o.x - 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = o.z - 0.5;
    UMBRAGE_HIGHP float eighth = o.y * 0.125;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b1 = z * 1.73205078 - x * 0.333333343;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b2 = o.w + eighth;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b3 = z * 1.29903817 - x * 0.75;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b4 = o.w - eighth;
    return vec4(b1, b2, b3, b4);
}
#endif
