// umbrage 0.1.0, compare_exercise: lit if current < stored + epsilon. Exactness: tier B.
// compare_exercise, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_COMPARE_EXERCISE
#define UMBRAGE_HAS_COMPARE_EXERCISE
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
inline float umbrage_compare_exercise(float current, float stored, float epsilon) {
    float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
#endif
