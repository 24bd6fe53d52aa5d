// umbrage 0.1.0, level_rg13: two channels to a level, for maps that are not decoded. Exactness: tier B.
// level_rg13, tier B: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_LEVEL_RG13
#define UMBRAGE_HAS_LEVEL_RG13
// umbrage_level_rg13: level of a texel from two channels of a 13-bit code, on the scale of umbrage_receiver_rg13
//   1.0 is not the far plane on this scale
inline float umbrage_level_rg13(float2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
#endif
