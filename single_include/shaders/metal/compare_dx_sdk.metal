// umbrage 0.1.0, compare_dx_sdk: stored + epsilon < receiver is shadow. Exactness: tier B.
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
