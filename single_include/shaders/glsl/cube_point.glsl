// umbrage 0.1.0, cube_point: point from a face's axes. Exactness: tier A.
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
