// umbrage 0.1.0, cascade_fade: weight of the next cascade, by view depth. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_fade, tier B: within 3 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_FADE
#define UMBRAGE_HAS_CASCADE_FADE
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
#endif
