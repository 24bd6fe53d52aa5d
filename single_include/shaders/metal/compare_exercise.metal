// umbrage 0.1.0, MIT License: compare_exercise

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
