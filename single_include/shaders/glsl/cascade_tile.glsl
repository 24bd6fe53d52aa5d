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
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
UMBRAGE_HIGHP vec2 umbrage_cascade_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 size) {
    UMBRAGE_HIGHP float row = floor(number * 0.5);
    return vec2(number - row * 2.0, row) * size;
}
#endif
