// umbrage 0.1.0, chebyshev_hardware: Chebyshev bound with light bleeding reduced. Exactness: tier C.
// chebyshev_hardware, tier C: within 1/524288 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
inline float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = metal::max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return metal::clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
#endif
