// umbrage 0.1.0, tetrahedron_face_point: direction in the axes of a tetrahedron's face. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
#define UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 d) {
    UMBRAGE_HIGHP vec3 z = face < 0.5 ? vec3(-d.x, d.y, d.z) : vec3(d.x, d.y, -d.z);
    UMBRAGE_HIGHP vec3 x = face < 2.5 ? vec3(-d.z, -d.y, d.x) : vec3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
#endif
