// umbrage 0.1.0, floor_divide: integer division that rounds down, exact on any GPU. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
#endif
