// umbrage 0.1.0, receiver_plane_slope: slope of a receiver's plane from derivatives, and its error. Exactness: tier
//   C.
// receiver_plane_slope, tier C: within 31 x 2^-23 x S of the exact result.
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

#ifndef UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
#define UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
float3 umbrage_receiver_plane_slope(float3 dx, float3 dy) {
    precise float determinant = dx.x * dy.y + dx.y * -dy.x;
    precise float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    precise float along_x = dy.y * dx.z + dx.y * -dy.z;
    precise float along_y = dx.x * dy.z + dy.x * -dx.z;
    float a = umbrage_clamp_slope(along_x / determinant);
    float b = umbrage_clamp_slope(along_y / determinant);
    precise float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    precise float error = off * (sum / abs(determinant));
    float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? float3(a, b, umbrage_clamp_slope(error)) : float3(0.0, 0.0, 0.0);
}
#endif
