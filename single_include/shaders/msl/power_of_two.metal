// umbrage 0.1.0, power_of_two: 2^n of integers n from -64 to 63. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
inline float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return as_type<float>(exponent << 23);
}
#endif
