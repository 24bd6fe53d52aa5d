// umbrage 0.1.0, depth_from_ndc: z/w in [-1, 1] to depth in [0, 1]. Exactness: tier B.
// depth_from_ndc, tier B: within 2 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_DEPTH_FROM_NDC
#define UMBRAGE_HAS_DEPTH_FROM_NDC
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
inline float umbrage_depth_from_ndc(float ndc) {
    float depth = ndc * 0.5 + 0.5;
    return depth;
}
#endif
