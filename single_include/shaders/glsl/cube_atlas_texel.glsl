// umbrage 0.1.0, cube_atlas_texel: face of an atlas texel, and the position on it. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CUBE_ATLAS_TEXEL
#define UMBRAGE_HAS_CUBE_ATLAS_TEXEL
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_texel(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    UMBRAGE_HIGHP float row = texel.y < size ? 0.0 : 1.0;
    return vec3(texel - vec2(column, row) * size, column + row * 3.0);
}
#endif
