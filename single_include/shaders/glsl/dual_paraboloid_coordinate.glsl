// umbrage 0.1.0, dual_paraboloid_coordinate: paraboloid map that sees a direction, and position in it. Exactness:
//   tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// dual_paraboloid_coordinate, tier C: within 32 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
#define UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
UMBRAGE_HIGHP vec3 umbrage_dual_paraboloid_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    UMBRAGE_HIGHP float m = sqrt(square) + (behind ? -direction.z : direction.z);
    UMBRAGE_HIGHP float x = behind ? direction.x : -direction.x;
    return vec3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
#endif
