// umbrage 0.1.0, blend_cascades: blend of two cascades' visibilities. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// blend_cascades, tier B: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_BLEND_CASCADES
#define UMBRAGE_HAS_BLEND_CASCADES
// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
UMBRAGE_HIGHP float umbrage_blend_cascades(UMBRAGE_HIGHP float nearer, UMBRAGE_HIGHP float farther,
                                           UMBRAGE_HIGHP float weight) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
#endif
