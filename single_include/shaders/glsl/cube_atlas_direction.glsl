// umbrage 0.1.0, cube_atlas_direction: direction that reads an atlas texel from a cube texture. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
UMBRAGE_HIGHP vec3 umbrage_cube_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(p.z, -p.y, -p.x) : vec3(-p.z, -p.y, p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
#define UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_direction(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec3 part = umbrage_cube_atlas_texel(texel, size);
    UMBRAGE_HIGHP vec2 uv = vec2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3(uv, size));
}
#endif
