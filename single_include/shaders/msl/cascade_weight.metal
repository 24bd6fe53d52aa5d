// umbrage 0.1.0, cascade_weight: weight in steps of 1/256. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
inline float umbrage_cascade_weight(float v) {
    float steps = v > 0.0 && v < 1.0 ? metal::floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
#endif
