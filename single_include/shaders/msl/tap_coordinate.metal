// umbrage 0.1.0, tap_coordinate: coordinate of a tap from the center's, before division by w. Exactness: tier B.
// tap_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TAP_COORDINATE
#define UMBRAGE_HAS_TAP_COORDINATE
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
inline float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
#endif
