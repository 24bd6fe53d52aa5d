// umbrage 0.1.0, receiver_ps14: receiver depth on the scale of decode_ps14. Exactness: tier B.
// receiver_ps14, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_RECEIVER_PS14
#define UMBRAGE_HAS_RECEIVER_PS14
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14. Beyond the far plane every texel lights
// it
inline float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
#endif
