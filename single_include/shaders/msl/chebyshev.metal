// umbrage 0.1.0, chebyshev: upper bound on visibility from mean and variance. Exactness: tier C.
// chebyshev, tier C: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
inline float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    float distance = receiver - m.x;
    float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? metal::min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
#endif
