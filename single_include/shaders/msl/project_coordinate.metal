// umbrage 0.1.0, project_coordinate: division by w; lit behind the light. Exactness: tier C.
// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_PROJECT_COORDINATE
#define UMBRAGE_HAS_PROJECT_COORDINATE
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
inline float3 umbrage_project_coordinate(float4 coordinate) {
    float3 p = float3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : float3(65536.0, 65536.0, 0.0);
}
#endif
