// umbrage 0.1.0, forward_depth: depth that grows with distance. Exactness: tier B.
// Tier B: GLSL below 400 and 320 es lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Options, to define in front:
//   UMBRAGE_REVERSED                  depth is 1.0 at the near plane and 0.0 at the far plane

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

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane, 1.0; after #define UMBRAGE_REVERSED 0.0
UMBRAGE_HIGHP float umbrage_cleared_depth() {
#ifdef UMBRAGE_REVERSED
    return 0.0;
#else
    return 1.0;
#endif
}
#endif

#ifndef UMBRAGE_HAS_FORWARD_DEPTH
#define UMBRAGE_HAS_FORWARD_DEPTH
// umbrage_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
UMBRAGE_HIGHP float umbrage_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif
