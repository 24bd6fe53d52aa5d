// umbrage 0.1.0, cascade_edge: texels beyond the part of a cascade where a filter stays inside. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_edge, tier B: within 11 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_EDGE
#define UMBRAGE_HAS_CASCADE_EDGE
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   coordinate   position in the cascade's map: texels, texels, depth
//   size, reach  size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], far from the map, and for NaN
UMBRAGE_HIGHP float umbrage_cascade_edge(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size,
                                         UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond =
        abs(vec2(coordinate.x, coordinate.y) - half_size) - (half_size - reach);
    bool near_map = beyond.x + beyond.y < 65536.0;  // false for NaN
    return coordinate.z >= 0.0 && coordinate.z <= 1.0 && near_map ? max(beyond.x, beyond.y) : 65536.0;
}
#endif
