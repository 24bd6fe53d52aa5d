// umbrage 0.1.0, cube_direction: direction to a point of a cube's face. Exactness: tier B.
// cube_direction, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
inline float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_DIRECTION
#define UMBRAGE_HAS_CUBE_DIRECTION
// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
inline float3 umbrage_cube_direction(float face, float2 st) {
    float2 uv = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, float3(uv, 1.0));
}
#endif
