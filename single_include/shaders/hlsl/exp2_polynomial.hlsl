// umbrage 0.1.0, exp2_polynomial: 2^y, off by at most 1.8e-7 of itself. Exactness: tier B.
// exp2_polynomial, tier B: within 16 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return asfloat(exponent << 23);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? min(y, 63.0) : -64.0;
    float n = floor(x);
    float f = x - n;
    precise float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
#endif
