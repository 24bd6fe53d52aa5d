// umbrage 0.1.0, cascade_coordinate: position of a point in one cascade's map. Exactness: tier B.
// cascade_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
inline float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif
