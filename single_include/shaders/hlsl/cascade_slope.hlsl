// umbrage 0.1.0, cascade_slope: change of a plane's depth per texel in a cascade. Exactness: tier C.
// cascade_slope, tier C: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CLAMP_SLOPE
#define UMBRAGE_HAS_CLAMP_SLOPE
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
float umbrage_clamp_slope(float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_SLOPE
#define UMBRAGE_HAS_CASCADE_SLOPE
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
float2 umbrage_cascade_slope(float3 normal, float4 scale) {
    precise float2 up = float2(normal.x, normal.y) * -scale.z;
    precise float2 across = float2(scale.x, scale.y) * normal.z;
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float2 slope = float2(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return none ? float2(0.0, 0.0) : slope;
}
#endif
