// umbrage 0.1.0, false_color: depth 0..1 as a color from blue over green to red. Exactness: tier B.
// false_color, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_FALSE_COLOR
#define UMBRAGE_HAS_FALSE_COLOR
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    precise float3 ramp = 1.5 - abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
#endif
