// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/esm.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("esm: by hand", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK(exponential_warp(T(0.5), T(40)) == 1);
    CHECK(exponential_warp(T(0), T(40)) == T(0x1p-40));
    CHECK(encode_esm(T(1), T(40)) == T(0x1p40));
    CHECK(encode_esm(T(1), T(40), T(0)) == T(0x1p-40));                                // reversed
    for (const T far : {T(0), T(1)}) CHECK(encode_esm(nan, T(40), far) == T(0x1p40));  // as cleared
    CHECK(decode_esm(T(0x1p30), T(1), T(40)) == T(0x1p-10));
    CHECK(decode_esm(T(0x1p30), T(0), T(40), T(0)) == T(0x1p-10));
    CHECK(decode_esm(T(0x1p63), T(0), T(63)) == 1);
    CHECK(decode_esm(T(0x1p40), T(-3), T(40)) == 1);
    CHECK(decode_esm(T(0x1p40), nan, T(40)) == 0);
    CHECK(decode_esm(nan, T(0.5), T(40)) == 0);
    CHECK(decode_esm(T(0), T(0.5), T(40)) == 0);
    CHECK(decode_esm(infinity, T(0.5), T(40)) == 1);
}

TEST_CASE("esm: setup") {
    CHECK(make_esm({.exponent = 63.0f}).exponent == 63.0f);
    CHECK(make_esm({.exponent = 14.0f, .store = float_store::half}).exponent == 14.0f);
    CHECK_THROWS_AS((void)make_esm({.exponent = 63.5f}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_esm({.exponent = 14.5f, .store = float_store::half}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_esm({.exponent = 0.0f}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_esm({.exponent = std::numeric_limits<float>::quiet_NaN()}), std::invalid_argument);
}

TEST_CASE("esm: never darker than the lit share, and within its bound of reals") {
    std::mt19937 random(9);
    double worst = 0, darker = 0;
    for (int i = 0; i < 100000; ++i) {
        const depth_window w(random);
        const float exponent = static_cast<float>(1 + random() % 63);
        const auto real = [&](float d) { return std::exp2(double(exponent * (d * 2.0f - 1.0f))); };
        const double m = w.mean([&](float d) { return double(encode_esm(d, exponent)); });
        const double got = decode_esm(float(m), w.receiver, exponent);
        worst = std::max(worst, std::abs(got - std::min(w.mean(real) / real(w.receiver), 1.0)));
        darker = std::max(darker, w.lit() - got);
    }
    CHECK(worst <= 0x1p-20);
    CHECK(darker <= 0x1p-20);
    MESSAGE("off by at most ", 0x1p-20, "; worst seen ", worst, ", darker ", darker);
    CHECK(decode_esm(encode_esm(0.5f, 33.0f), 0.6f, 33.0f) == doctest::Approx(0.0103).epsilon(0.01));
}
