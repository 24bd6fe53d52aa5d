// umbrage 0.1.0, kernel_bias: bias from kernel width and angle of the light. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// kernel_bias, tier C: within 30 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_KERNEL_BIAS
#define UMBRAGE_HAS_KERNEL_BIAS
// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
UMBRAGE_HIGHP float umbrage_kernel_bias(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 way,
                                        UMBRAGE_HIGHP float width, UMBRAGE_HIGHP float greatest) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_HIGHP float sine = sqrt(square);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge = cosine * greatest;
    UMBRAGE_HIGHP float tangent = edge > sine ? sine / cosine : greatest;
    UMBRAGE_HIGHP float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
#endif
