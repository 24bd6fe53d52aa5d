// umbrage 0.1.0, cascade_border_fade: weight of the next cascade, by distance from the border. Exactness: tier B.
// GLSL below 400 and 320 es lets compilers fuse or reorder sums.
// cascade_border_fade, tier B: within 8 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_CASCADE_BORDER_FADE
#define UMBRAGE_HAS_CASCADE_BORDER_FADE
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
UMBRAGE_HIGHP float umbrage_cascade_border_fade(UMBRAGE_HIGHP vec2 coordinate, UMBRAGE_HIGHP vec2 size,
                                                UMBRAGE_HIGHP float reach, UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond = abs(coordinate - half_size) - (half_size - reach);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = beyond * per_texel + 1.0;
    UMBRAGE_HIGHP float x = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
#endif
