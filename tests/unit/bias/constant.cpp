// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <limits>
#include <random>

#include <umbrage/bias/constant.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("biased: towards the light, whichever way depth runs", T, float, double) {
    CHECK(biased(T(0.5), T(0.125)) == T(0.375));
    CHECK(biased(T(0.5), T(0.125), depth_direction::forward) == T(0.375));
    CHECK(biased(T(0.5), T(0.125), depth_direction::reversed) == T(0.625));
    CHECK(biased(T(0.5), T(-0.125)) == T(0.625));
    static_assert(biased(T(1), T(0.25)) == T(0.75));
}

TEST_CASE("biased: a receiver and its mirror image are lit alike") {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> code(0, 1 << 20);  // of which 1 - depth is exact
    const auto depth = [&] { return static_cast<float>(code(random)) * 0x1p-20f; };
    int lit = 0;
    for (int i = 0; i < 10000; ++i) {
        const float receiver = depth(), stored = depth(), bias = depth() - 0.5f;
        const bool forward = less_equal{}(biased(receiver, bias), stored);
        CHECK(forward == greater_equal{}(biased(1 - receiver, bias, depth_direction::reversed), 1 - stored));
        lit += forward;
    }
    CHECK(lit > 3000);
    CHECK(lit < 7000);
}

TEST_CASE_TEMPLATE("biased, clamp_bias: out of range", T, float, double) {
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (T none : {inf, -inf, nan, -nan, T(0x1p64), T(-0x1p64), T(0)}) {
        CHECK(biased(T(0.5), none) == T(0.5));
        CHECK(biased(T(0.5), none, depth_direction::reversed) == T(0.5));
    }
    CHECK(is_nan(biased(nan, T(0.1))));
    CHECK(biased(T(1), T(0x1p63)) < T(-0x1p62));
    for (T least : {T(0), T(-0.0), T(-1), -inf}) CHECK(clamp_bias(least) == 0);
    for (T most : {T(1), T(1.5), inf, nan, -nan}) CHECK(clamp_bias(most) == 1);
    CHECK(clamp_bias(T(0.375)) == T(0.375));
    CHECK(clamp_bias(T(0x1p-64)) == T(0x1p-64));
    CHECK(clamp_bias(T(0x1.fp-65)) == 0);
}
