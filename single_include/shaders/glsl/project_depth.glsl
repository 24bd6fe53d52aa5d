// umbrage 0.1.0, project_depth: z / w, and the far plane behind the light. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// project_depth, tier C: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_PROJECT_DEPTH
#define UMBRAGE_HAS_PROJECT_DEPTH
// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
UMBRAGE_HIGHP float umbrage_project_depth(UMBRAGE_HIGHP float z, UMBRAGE_HIGHP float w, UMBRAGE_HIGHP float cleared) {
    return w > 0.0 ? z / w : cleared;
}
#endif
