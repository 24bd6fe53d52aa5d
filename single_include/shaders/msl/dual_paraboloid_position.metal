// umbrage 0.1.0, dual_paraboloid_position: position of a vertex in a paraboloid map's depth pass. Exactness: tier C.
// dual_paraboloid_position, tier C: within 18 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
#define UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
inline float4 umbrage_dual_paraboloid_position(float3 direction, float map) {
    bool behind = map > 0.5;
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float distance_to = metal::sqrt(square);
    float w = distance_to + (behind ? -direction.z : direction.z);
    return float4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
#endif
