// umbrage 0.1.0, bias_moments: four moments (MSM) with a bias against rounding. Exactness: tier B.
// bias_moments, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
inline float4 umbrage_bias_moments(float4 b, float2 bias) {
    float x = b.x - b.x * bias.x;
    float y = b.y + (bias.y - b.y) * bias.x;
    float z = b.z - b.z * bias.x;
    float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
#endif
