// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/cascades/splits.hpp>

#include <cmath>
#include <limits>
#include <string>

#include "../clip_spaces.hpp"

using namespace umbrage;
using doctest::Approx;

TEST_CASE_TEMPLATE("practical_splits: by hand, even, by one factor and between", T, float, double) {
    const auto even = practical_splits<4>(T(2), T(10), T(0));
    const auto factor = practical_splits<3>(T(1), T(1000), T(1));
    const auto between = practical_splits<2>(T(1), T(9), T(0.25));
    for (std::size_t i = 0; i < 5; ++i) CHECK(even[i] == Approx(2.0 + 2.0 * double(i)));
    for (std::size_t i = 0; i < 4; ++i) CHECK(factor[i] == Approx(std::pow(10.0, double(i))));
    CHECK(between[1] == Approx(0.25 * 3 + 0.75 * 5));
    CHECK(factor.front() == T(1));
    CHECK(factor.back() == T(1000));
}

TEST_CASE_TEMPLATE("practical_splits: the ends of the numbers are cut without overflow", T, float, double) {
    const T least = std::numeric_limits<T>::min(), greatest = std::numeric_limits<T>::max();
    for (const T lambda : {T(0), T(0.5), T(1)}) {
        const auto splits = practical_splits<8>(least, greatest, lambda);
        CHECK(splits.front() == least);
        CHECK(splits.back() == greatest);
        for (std::size_t i = 0; i < 8; ++i) CHECK((is_finite(splits[i]) && splits[i] < splits[i + 1]));
    }
}

TEST_CASE("practical_splits: what cannot be cut is named") {
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    const auto of = [](float n, float f, float lambda) {
        return complaint([=] { (void)practical_splits<4>(n, f, lambda); });
    };
    for (const float n : {0.0f, -1.0f, nan, infinity})
        CHECK(of(n, 10.0f, 0.5f).starts_with("umbrage::practical_splits: z_near must be finite and above 0; got "));
    for (const float f : {1.0f, 0.5f, nan, infinity})
        CHECK(of(1.0f, f, 0.5f).starts_with("umbrage::practical_splits: z_far must be finite and above z_near; got "));
    for (const float lambda : {-0.1f, 1.1f, nan})
        CHECK(of(1.0f, 2.0f, lambda).starts_with("umbrage::practical_splits: lambda must be from 0 to 1; got "));
    CHECK(of(1.0f, std::nextafter(1.0f, 2.0f), 0.5f) ==
          "umbrage::practical_splits: z_near and z_far must be farther apart; got (1, 1)");
    CHECK(of(1.0f, 1.001f, 1.0f).empty());
}
