// umbrage 0.1.0, tetrahedron_texel: a point of a tetrahedron's face in the map. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// tetrahedron_texel, tier B: within 9 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_TEXEL
#define UMBRAGE_HAS_TETRAHEDRON_TEXEL
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_texel(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP float size,
                                             UMBRAGE_HIGHP float border) {
    UMBRAGE_HIGHP float half_size = size * 0.5;
    UMBRAGE_HIGHP float scale = half_size - border * 3.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = at.x * scale;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = at.y * scale + (border - half_size);
    UMBRAGE_HIGHP vec2 off = at.z < 1.5 ? vec2(x, y) : vec2(-y, x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 texel = half_size + (at.z < 0.5 || (at.z > 1.5 && at.z < 2.5) ? off : -off);
    return texel;
}
#endif
