// umbrage 0.1.0, tetrahedron_turned: vector rotated from face 0's part of the map to another's. Exactness: tier A.
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
