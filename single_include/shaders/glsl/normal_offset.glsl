// umbrage 0.1.0, normal_offset: offset along the normal to the point to look up. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// normal_offset, tier C: within 91 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_NORMAL_OFFSET
#define UMBRAGE_HAS_NORMAL_OFFSET
// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
UMBRAGE_HIGHP vec3 umbrage_normal_offset(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction,
                                         UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP float width,
                                         UMBRAGE_HIGHP float error_world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = width * sqrt(square) + error_world * abs(straight);
    UMBRAGE_HIGHP vec3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : vec3(0.0, 0.0, 0.0);
}
#endif
