// umbrage 0.1.0, exp2_steps: 2^y in steps of 12 bits. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
UMBRAGE_HIGHP float umbrage_power_of_two(UMBRAGE_HIGHP float n) {
#if __VERSION__ >= 300
    UMBRAGE_HIGHP uint exponent = uint(n + 127.0);
    return uintBitsToFloat(exponent << 23);
#else
    UMBRAGE_HIGHP float x = n < 0.0 ? n + 64.0 : n;
    UMBRAGE_HIGHP float p = 1.0;
    p = n < 0.0 ? p * (1.0 / 4294967296.0) * (1.0 / 4294967296.0) : p;
    p = x >= 32.0 ? p * 4294967296.0 : p;
    x = x >= 32.0 ? x - 32.0 : x;
    p = x >= 16.0 ? p * 65536.0 : p;
    x = x >= 16.0 ? x - 16.0 : x;
    p = x >= 8.0 ? p * 256.0 : p;
    x = x >= 8.0 ? x - 8.0 : x;
    p = x >= 4.0 ? p * 16.0 : p;
    x = x >= 4.0 ? x - 4.0 : x;
    p = x >= 2.0 ? p * 4.0 : p;
    x = x >= 2.0 ? x - 2.0 : x;
    return x >= 1.0 ? p * 2.0 : p;
#endif
}
#endif

#ifndef UMBRAGE_HAS_EXP2_STEPS
#define UMBRAGE_HAS_EXP2_STEPS
// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
UMBRAGE_HIGHP float umbrage_exp2_steps(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    UMBRAGE_HIGHP float n = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    UMBRAGE_HIGHP float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    UMBRAGE_HIGHP float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
#endif
