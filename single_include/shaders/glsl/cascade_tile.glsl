// umbrage 0.1.0, cascade_tile: first texel of a cascade in an atlas. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CASCADE_TILE
#define UMBRAGE_HAS_CASCADE_TILE
// umbrage_cascade_tile: first texel of a cascade, 0.0 to 3.0, in an atlas of 2 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cascade_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = number < 1.5 ? 0.0 : 1.0;
    return vec2((number - row * 2.0) * size, row * size);
}
#endif
