// umbrage 0.1.0, receiver_rg10: receiver to a level, for maps that are not decoded. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// receiver_rg10, tier B: within 2 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_RECEIVER_RG10
#define UMBRAGE_HAS_RECEIVER_RG10
// umbrage_receiver_rg10: receiver depth on the scale of umbrage_level_rg10. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg10(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif
