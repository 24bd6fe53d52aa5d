// umbrage 0.1.0, cube_point: point from a face's axes. Exactness: tier A.
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
