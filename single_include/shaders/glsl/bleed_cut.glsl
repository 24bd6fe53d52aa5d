// umbrage 0.1.0, bleed_cut: visibility without its least values. Exactness: tier C.
// Tier C: GLSL below 400 and 320 es lets compilers fuse or reorder sums. Results then stay within the stated bound.
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

#ifndef UMBRAGE_HAS_BLEED_CUT
#define UMBRAGE_HAS_BLEED_CUT
// umbrage_bleed_cut: visibility from amount to 1.0 stretched to 0.0 to 1.0, so that less light bleeds through
UMBRAGE_HIGHP float umbrage_bleed_cut(UMBRAGE_HIGHP float visibility, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
#endif
