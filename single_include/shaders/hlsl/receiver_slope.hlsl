// umbrage 0.1.0, receiver_slope: change of a receiver's depth per texel. Exactness: tier C.
// receiver_slope, tier C: within 27 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_PLANE_SLOPE
#define UMBRAGE_HAS_PLANE_SLOPE
// umbrage_plane_slope: change of depth per texel, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
float2 umbrage_plane_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    precise float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    precise float4 q = transpose(plane_matrix)[3] * d + transpose(plane_matrix)[0] * normal.x +
        transpose(plane_matrix)[1] * normal.y + transpose(plane_matrix)[2] * normal.z;
    return float2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_SLOPE
#define UMBRAGE_HAS_RECEIVER_SLOPE
// umbrage_receiver_slope: umbrage_plane_slope, but (0.0, 0.0) for a normal of zero (the caller has none)
float2 umbrage_receiver_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    float2 slope = umbrage_plane_slope(plane_matrix, normal, world);
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : slope;
}
#endif
