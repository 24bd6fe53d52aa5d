// umbrage 0.1.0, spot_cone: 1 inside a spot light's cone, else 0. Exactness: tier B.
// spot_cone, tier B: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_SPOT_CONE
#define UMBRAGE_HAS_SPOT_CONE
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
inline float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    float edge2 = cos_outer * cos_outer * length2;
    float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
#endif
