// umbrage 0.1.0, dual_paraboloid_slope: change of distance per texel in a dual paraboloid map. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// dual_paraboloid_slope, tier C: within 41 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CLAMP_SLOPE
#define UMBRAGE_HAS_CLAMP_SLOPE
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return abs(slope) < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
#endif

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
#define UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
UMBRAGE_HIGHP vec2 umbrage_dual_paraboloid_slope(UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = way.x * way.x + way.y * way.y + way.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * way.z - normal.z * way.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * way.x - normal.x * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * way.y - normal.y * way.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float across = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    UMBRAGE_HIGHP float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : vec2(slope, slope);
}
#endif
