// umbrage 0.1.0, cube_coordinate: face of a direction, and the position on it. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cube_coordinate, tier C: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CUBE_VIEW_Z
#define UMBRAGE_HAS_CUBE_VIEW_Z
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
UMBRAGE_HIGHP float umbrage_cube_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
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

#ifndef UMBRAGE_HAS_CUBE_COORDINATE
#define UMBRAGE_HAS_CUBE_COORDINATE
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(direction);
    UMBRAGE_HIGHP float m = umbrage_cube_view_z(direction);
    return vec3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
#endif
