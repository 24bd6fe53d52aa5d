// umbrage 0.1.0, receiver_plane_slope: slope of a receiver's plane from derivatives, and its error. Exactness: tier
//   C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// receiver_plane_slope, tier C: within 31 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
#define UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
UMBRAGE_HIGHP vec3 umbrage_receiver_plane_slope(UMBRAGE_HIGHP vec3 dx, UMBRAGE_HIGHP vec3 dy) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float determinant = dx.x * dy.y + dx.y * -dy.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_x = dy.y * dx.z + dx.y * -dy.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_y = dx.x * dy.z + dy.x * -dx.z;
    UMBRAGE_HIGHP float a = umbrage_clamp_slope(along_x / determinant);
    UMBRAGE_HIGHP float b = umbrage_clamp_slope(along_y / determinant);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float error = off * (sum / abs(determinant));
    UMBRAGE_HIGHP float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? vec3(a, b, umbrage_clamp_slope(error)) : vec3(0.0, 0.0, 0.0);
}
#endif
