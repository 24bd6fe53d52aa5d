// umbrage 0.1.0, next_cascade_weight: weight of the next cascade, by both edges. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// next_cascade_weight, tier B: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
#define UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
UMBRAGE_HIGHP float umbrage_next_cascade_weight(UMBRAGE_HIGHP vec3 found, UMBRAGE_HIGHP vec4 blending) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = vec2(found.y, found.z) * blending.x + 1.0;
    UMBRAGE_HIGHP float leaves = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float held = found.z <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    UMBRAGE_HIGHP float weight = found.x >= blending.y ? leaves : min(leaves, held);
    return blending.x > 0.0 && found.x <= blending.y ? weight : 0.0;
}
#endif
