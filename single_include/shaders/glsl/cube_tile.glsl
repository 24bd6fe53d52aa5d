// umbrage 0.1.0, cube_tile: first texel of a face in an atlas. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CUBE_TILE
#define UMBRAGE_HAS_CUBE_TILE
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cube_tile(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = face < 2.5 ? 0.0 : 1.0;
    return vec2((face - row * 3.0) * size, row * size);
}
#endif
