// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/exp2.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace umbrage;

TEST_CASE_TEMPLATE("exp2: whole numbers give powers of two; what is beyond the ends, and NaN", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    for (int n = -64; n <= 63; ++n) {
        CHECK(power_of_two(T(n)) == std::ldexp(T(1), n));
        CHECK(exp2_polynomial(T(n)) == std::ldexp(T(1), n));
        CHECK(exp2_steps(T(n)) == std::ldexp(T(1), n));
    }
    for (const auto power : {exp2_polynomial<T>, exp2_steps<T>}) {
        for (const T low : {T(-65), -infinity, nan, -nan}) CHECK(power(low) == T(0x1p-64));
        for (const T high : {T(63.5), T(1e9), infinity}) CHECK(power(high) == T(0x1p63));
    }
}

TEST_CASE("exp2_polynomial: over all f = k / 2^24 it never falls and keeps its bound") {
    double worst = 0;
    int falls = 0;
    float before = 1;
    for (int k = 0; k < 1 << 24; ++k) {
        const float f = static_cast<float>(k) * 0x1p-24f, power = exp2_polynomial(f);
        const double true_power = std::exp2(double(f));
        worst = std::max(worst, std::abs(power - true_power) / true_power);
        falls += power < before;
        before = power;
    }
    CHECK(falls == 0);
    CHECK(before <= 2.0f);
    CHECK(worst < 1.8e-7);
    MESSAGE("off by at most 1.8e-7 of the power; worst seen ", worst);
    int wrong = 0;
    for (int k = -64 * 2048; k <= 63 * 2048; ++k) {
        const float y = static_cast<float>(k) * 0x1p-11f, n = std::floor(y);
        wrong += exp2_polynomial(y) != std::ldexp(exp2_polynomial(y - n), int(n));
    }
    CHECK(wrong == 0);
}

TEST_CASE("exp2_steps: over all steps it never falls and keeps its bound, with an exact square") {
    double worst = 0;
    int wrong = 0;
    for (int k = -64 * 2048; k < 63 * 2048; ++k) {
        const float y = static_cast<float>(k) * 0x1p-11f, power = exp2_steps(y);
        const double true_power = std::exp2(double(y));
        worst = std::max(worst, std::abs(power - true_power) / true_power);
        wrong += exp2_steps(y + 0x1p-11f) < power;
        wrong += exp2_steps(y + 0x1.fp-12f) != power;
        wrong += y >= -63.0f && double(power * power) != double(power) * double(power);
        wrong += exp2_steps(double(y)) != double(power);
    }
    CHECK(wrong == 0);
    CHECK(worst < 3.1e-4);
    MESSAGE("off by at most 3.1e-4 of the power; worst seen ", worst);
}
