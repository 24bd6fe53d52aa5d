// umbrage 0.1.0, depth_from_ndc: z/w in [-1, 1] to depth in [0, 1]. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// depth_from_ndc, tier B: within 2 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DEPTH_FROM_NDC
#define UMBRAGE_HAS_DEPTH_FROM_NDC
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
UMBRAGE_HIGHP float umbrage_depth_from_ndc(UMBRAGE_HIGHP float ndc) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ndc * 0.5 + 0.5;
    return depth;
}
#endif
