// umbrage 0.1.0, reduce_light_bleeding: visibility above a threshold, stretched to [0, 1]. Exactness: tier C.
// reduce_light_bleeding, tier C: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_REDUCE_LIGHT_BLEEDING
#define UMBRAGE_HAS_REDUCE_LIGHT_BLEEDING
// umbrage_reduce_light_bleeding: visibility from amount to 1.0, stretched to 0.0 to 1.0
inline float umbrage_reduce_light_bleeding(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
#endif
