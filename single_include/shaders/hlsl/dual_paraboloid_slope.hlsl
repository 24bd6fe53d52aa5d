// umbrage 0.1.0, dual_paraboloid_slope: change of distance per texel in a dual paraboloid map. Exactness: tier C.
// dual_paraboloid_slope, tier C: within 41 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
#define UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
float2 umbrage_dual_paraboloid_slope(float3 way, float3 normal, float per_texel) {
    precise float square = way.x * way.x + way.y * way.y + way.z * way.z;
    precise float x = normal.y * way.z - normal.z * way.y;
    precise float y = normal.z * way.x - normal.x * way.z;
    precise float z = normal.x * way.y - normal.y * way.x;
    precise float across = x * x + y * y + z * z;
    precise float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    precise float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : float2(slope, slope);
}
#endif
