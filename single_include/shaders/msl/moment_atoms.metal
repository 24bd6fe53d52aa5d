// umbrage 0.1.0, moment_atoms: two depths that have the moments with the receiver's. Exactness: tier C.
// moment_atoms, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
inline float4 umbrage_moment_atoms(float4 b, float x) {
    float d = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float l = third / d;
    float e = (b.w - b.y * b.y) - third * l;
    float h = b.x * 2.0 - l;
    float a = d * ((x + h) * x - d);
    float m = x * e + h * a;
    float c = d * (e - a);
    float square = m * m - 4.0 * a * c;
    float root = metal::sqrt(square > 0.0 ? square : 0.0);
    float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    float2 q = (t + h) * t - d;
    float least = d * e;
    float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif
