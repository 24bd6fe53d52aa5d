// umbrage 0.1.0, MIT License: power_of_two

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
inline float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return as_type<float>(exponent << 23);
}
#endif
