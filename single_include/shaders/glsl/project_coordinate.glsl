// umbrage 0.1.0, project_coordinate: division by w; lit behind the light. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_PROJECT_COORDINATE
#define UMBRAGE_HAS_PROJECT_COORDINATE
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
UMBRAGE_HIGHP vec3 umbrage_project_coordinate(UMBRAGE_HIGHP vec4 coordinate) {
    UMBRAGE_HIGHP vec3 p = vec3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : vec3(65536.0, 65536.0, 0.0);
}
#endif
