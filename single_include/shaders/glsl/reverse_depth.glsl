// umbrage 0.1.0, reverse_depth: 1 - depth. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// reverse_depth, tier B: within 1 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_REVERSE_DEPTH
#define UMBRAGE_HAS_REVERSE_DEPTH
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
UMBRAGE_HIGHP float umbrage_reverse_depth(UMBRAGE_HIGHP float depth) {
    return 1.0 - depth;
}
#endif
