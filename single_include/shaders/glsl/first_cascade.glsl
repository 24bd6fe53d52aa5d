// umbrage 0.1.0, first_cascade: first of four cascades that holds a point and its filter. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_FIRST_CASCADE
#define UMBRAGE_HAS_FIRST_CASCADE
// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
UMBRAGE_HIGHP vec3 umbrage_first_cascade(UMBRAGE_HIGHP vec4 edges) {
    UMBRAGE_HIGHP vec3 found = edges.w <= 0.0 ? vec3(3.0, edges.w, 65536.0) : vec3(4.0, 65536.0, 65536.0);
    found = edges.z <= 0.0 ? vec3(2.0, edges.z, edges.w) : found;
    found = edges.y <= 0.0 ? vec3(1.0, edges.y, edges.z) : found;
    return edges.x <= 0.0 ? vec3(0.0, edges.x, edges.y) : found;
}
#endif
