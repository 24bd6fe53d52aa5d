// umbrage 0.1.0, exp2_steps: 2^y in steps of 12 bits. Exactness: tier A.
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

#ifndef UMBRAGE_HAS_EXP2_STEPS
#define UMBRAGE_HAS_EXP2_STEPS
// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_steps(float y) {
    float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    float n = floor(x * (1.0 / 2048.0));
    float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
#endif
