// umbrage 0.1.0, cube_neighbor: texel beyond an edge of a cube's face. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_PLANE
#define UMBRAGE_HAS_CUBE_PLANE
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
UMBRAGE_HIGHP vec3 umbrage_cube_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP vec3 x = vec3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    UMBRAGE_HIGHP vec3 y = vec3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    UMBRAGE_HIGHP vec3 z = vec3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
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

#ifndef UMBRAGE_HAS_CUBE_NEIGHBOR
#define UMBRAGE_HAS_CUBE_NEIGHBOR
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
UMBRAGE_HIGHP vec3 umbrage_cube_neighbor(UMBRAGE_HIGHP vec3 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 uv = vec2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    UMBRAGE_HIGHP float m = beyond_u || beyond_v ? size - 1.0 : size;
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3(uv, m)));
    UMBRAGE_HIGHP vec2 inside = (vec2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? vec3(0.0, 0.0, -1.0) : vec3(inside, p.z);
}
#endif
