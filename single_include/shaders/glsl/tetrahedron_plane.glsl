// umbrage 0.1.0, tetrahedron_plane: direction in the axes of its tetrahedron face. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// tetrahedron_plane, tier B: within 1 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE
#define UMBRAGE_HAS_TETRAHEDRON_FACE
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
UMBRAGE_HIGHP float umbrage_tetrahedron_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside = abs(direction.z) - abs(direction.x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float up = direction.y * 1.414213562;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
#define UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 d) {
    UMBRAGE_HIGHP vec3 z = face < 0.5 ? vec3(-d.x, d.y, d.z) : vec3(d.x, d.y, -d.z);
    UMBRAGE_HIGHP vec3 x = face < 2.5 ? vec3(-d.z, -d.y, d.x) : vec3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_PLANE
#define UMBRAGE_HAS_TETRAHEDRON_PLANE
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_plane(UMBRAGE_HIGHP vec3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
#endif
