// umbrage 0.1.0, shadow_coordinate: world to texels and depth, before the division by w. Exactness: tier B.
// shadow_coordinate, tier B: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_SHADOW_COORDINATE
#define UMBRAGE_HAS_SHADOW_COORDINATE
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
inline float4 umbrage_shadow_coordinate(metal::float4x4 m, float3 world) {
    float4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
#endif
