// umbrage 0.1.0, level_rg10: two channels to a level, for maps that are not decoded. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// level_rg10, tier B: within 4 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_LEVEL_RG10
#define UMBRAGE_HAS_LEVEL_RG10
// umbrage_level_rg10: level of a texel from two channels of a 10-bit code, on the scale of umbrage_receiver_rg10
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_level_rg10(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
#endif
