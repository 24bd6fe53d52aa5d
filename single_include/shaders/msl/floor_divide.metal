// umbrage 0.1.0, floor_divide: whole numbers divided and rounded down, whatever the division's error. Exactness: tier
//   A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
inline float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
inline float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(metal::floor(a / b), a, b);
}
#endif
