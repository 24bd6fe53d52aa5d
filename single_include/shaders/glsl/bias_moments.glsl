// umbrage 0.1.0, bias_moments: four moments (MSM) with a bias against rounding. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// bias_moments, tier B: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
UMBRAGE_HIGHP vec4 umbrage_bias_moments(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = b.x - b.x * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = b.y + (bias.y - b.y) * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = b.z - b.z * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = b.w + (bias.y - b.w) * bias.x;
    return vec4(x, y, z, w);
}
#endif
