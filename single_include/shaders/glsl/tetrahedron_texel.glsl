// umbrage 0.1.0, tetrahedron_texel: position in the map of a point on a tetrahedron's face. Exactness: tier B.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_TURNED
#define UMBRAGE_HAS_TETRAHEDRON_TURNED
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_turned(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 v) {
    UMBRAGE_HIGHP vec2 z = face < 0.5 ? v : vec2(-v.x, -v.y);
    UMBRAGE_HIGHP vec2 x = face < 2.5 ? vec2(-v.y, v.x) : vec2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_TEXEL
#define UMBRAGE_HAS_TETRAHEDRON_TEXEL
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_texel(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP float size,
                                             UMBRAGE_HIGHP float border) {
    UMBRAGE_HIGHP float half_size = size * 0.5;
    UMBRAGE_HIGHP float scale = half_size - border * 3.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = at.x * scale;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = at.y * scale + (border - half_size);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 texel = umbrage_tetrahedron_turned(at.z, vec2(x, y)) + half_size;
    return texel;
}
#endif
