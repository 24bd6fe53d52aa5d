// umbrage 0.1.0, world_to_depth: world units along a light to depth. Exactness: tier C.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// world_to_depth, tier C: within 5 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CLAMP_BIAS
#define UMBRAGE_HAS_CLAMP_BIAS
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias < 1.0 ? (bias >= least ? bias : 0.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WORLD_TO_DEPTH
#define UMBRAGE_HAS_WORLD_TO_DEPTH
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
UMBRAGE_HIGHP float umbrage_world_to_depth(UMBRAGE_HIGHP float world, UMBRAGE_HIGHP vec2 units,
                                           UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = world * units.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = w * w;
    return umbrage_clamp_bias(along / square);
}
#endif
