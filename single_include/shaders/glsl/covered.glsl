// umbrage 0.1.0, covered: share of the texels around a point that lie in the map, along each axis. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// covered, tier C: within 6 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_COVERED
#define UMBRAGE_HAS_COVERED
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP vec2 umbrage_covered(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return vec2(1.0, 1.0);
}
#endif
