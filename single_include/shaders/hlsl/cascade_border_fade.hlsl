// umbrage 0.1.0, cascade_border_fade: weight of the next cascade, by distance from the border. Exactness: tier B.
// cascade_border_fade, tier B: within 8 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
float umbrage_cascade_weight(float v) {
    float steps = v > 0.0 && v < 1.0 ? floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BORDER_FADE
#define UMBRAGE_HAS_CASCADE_BORDER_FADE
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
float umbrage_cascade_border_fade(float2 coordinate, float2 size, float reach, float per_texel) {
    float2 half_size = size * 0.5;
    precise float2 beyond = abs(coordinate - half_size) - (half_size - reach);
    precise float2 v = beyond * per_texel + 1.0;
    float x = umbrage_cascade_weight(v.x);
    float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
#endif
