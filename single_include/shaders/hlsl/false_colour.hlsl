// umbrage 0.1.0, false_colour: 0..1 to blue, green, red. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_FALSE_COLOUR
#define UMBRAGE_HAS_FALSE_COLOUR
// umbrage_false_colour: blue for 0.0, through green, to red for 1.0
float3 umbrage_false_colour(float v) {
    float x = umbrage_saturate(v) * 4.0;
    precise float3 ramp = 1.5 - abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
#endif
