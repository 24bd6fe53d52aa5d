// umbrage 0.1.0, normal_offset: offset along the normal to the point to look up. Exactness: tier C.
// normal_offset, tier C: within 91 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_NORMAL_OFFSET
#define UMBRAGE_HAS_NORMAL_OFFSET
// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
inline float3 umbrage_normal_offset(float3 normal, float3 direction, float3 way, float width, float error_world) {
    float x = normal.y * direction.z + normal.z * -direction.y;
    float y = normal.z * direction.x + normal.x * -direction.z;
    float z = normal.x * direction.y + normal.y * -direction.x;
    float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float square = x * x + y * y + z * z;
    float along = width * metal::sqrt(square) + error_world * metal::abs(straight);
    float3 offset = normal * along;
    return metal::abs(offset.x) + metal::abs(offset.y) +
        metal::abs(offset.z) < 18446744073709551616.0 ? offset : float3(0.0, 0.0, 0.0);
}
#endif
