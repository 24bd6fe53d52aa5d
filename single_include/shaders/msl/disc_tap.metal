// umbrage 0.1.0, disc_tap: texel that a point of a disc falls on. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     in 1/16 texel, an integer from 0 to 4095
inline float2 umbrage_disc_tap(float2 position, float2 p, float2 rotation, float radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = metal::floor(at);
    float2 within = metal::clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 scaled = rotation * (radius * (1.0 / 16384.0));
    float x = scaled.x * p.x + within.x - scaled.y * p.y;
    float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + metal::floor(float2(x, y));
}
#endif
