// umbrage 0.1.0, corner_reference: depth that four texels are compared with, by the receiver's plane. Exactness: tier
//   C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// corner_reference, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

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
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_CORNER_REFERENCE
#define UMBRAGE_HAS_CORNER_REFERENCE
// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
UMBRAGE_HIGHP float umbrage_corner_reference(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP vec2 way,
                                             UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float plane = (receiver + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, receiver) : max(plane, receiver);
}
#endif
