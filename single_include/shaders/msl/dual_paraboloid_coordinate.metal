// umbrage 0.1.0, dual_paraboloid_coordinate: paraboloid map that sees a direction, and position in it. Exactness:
//   tier C.
// dual_paraboloid_coordinate, tier C: within 32 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
#define UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
inline float3 umbrage_dual_paraboloid_coordinate(float3 direction) {
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    float m = metal::sqrt(square) + (behind ? -direction.z : direction.z);
    float x = behind ? direction.x : -direction.x;
    return float3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
#endif
