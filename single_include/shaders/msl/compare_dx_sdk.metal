// umbrage 0.1.0, compare_dx_sdk: shadow if stored + epsilon < receiver. Exactness: tier B.
// compare_dx_sdk, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_COMPARE_DX_SDK
#define UMBRAGE_HAS_COMPARE_DX_SDK
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
inline float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
#endif
