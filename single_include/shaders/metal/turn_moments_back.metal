// umbrage 0.1.0, turn_moments_back: four channels of 16 bits to four moments. Exactness: tier B.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TURN_MOMENTS_BACK
#define UMBRAGE_HAS_TURN_MOMENTS_BACK
// umbrage_turn_moments_back: four moments of what umbrage_turn_moments made of them
inline float4 umbrage_turn_moments_back(float4 o) {
    float x = o.x - 0.5;
    float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    float b1 = z * 1.73205078 - x * 0.333333343;
    float b2 = o.w + eighth;
    float b3 = z * 1.29903817 - x * 0.75;
    float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
#endif
