// umbrage 0.1.0, correct_quotient: a quotient of whole numbers, from one at most one off. Exactness: tier A.
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
