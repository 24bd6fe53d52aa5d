// umbrage 0.1.0, shaped_softness: softness of a place, by its shape. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// shaped_softness, tier C: within 9 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_SHAPED_SOFTNESS
#define UMBRAGE_HAS_SHAPED_SOFTNESS
// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
UMBRAGE_HIGHP vec4 umbrage_shaped_softness(UMBRAGE_HIGHP vec4 softness, UMBRAGE_HIGHP vec3 shape) {
    UMBRAGE_HIGHP float max_radius = softness.w / sqrt(1.0 + shape.z * shape.z);
    return vec4(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
#endif
