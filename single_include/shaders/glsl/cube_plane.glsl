// umbrage 0.1.0, cube_plane: direction in the axes of its face. Exactness: tier A.
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
