// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/evsm.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("evsm: by hand", T, float, double) {
    using vec2 = glm::vec<2, T>;
    using vec4 = glm::vec<4, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const vec2 exponents(60, 8), deviations(T(0.01));
    const vec4 cleared(T(0x1p60), T(0x1p120), -T(0x1p-8), T(0x1p-16));
    CHECK(encode_evsm4(T(1), exponents) == cleared);
    CHECK(encode_evsm2(T(1), T(60)) == vec2(cleared));
    for (const T far : {T(0), T(1)}) {
        CHECK(encode_evsm4(nan, exponents, far) == cleared);
        CHECK(encode_evsm2(nan, T(60), far) == vec2(cleared));
        CHECK(encode_evsm4(T(1) - far, exponents, far) == encode_evsm4(T(0), exponents));
    }
    CHECK(decode_evsm4(cleared, T(1), exponents, deviations) == 1);
    CHECK(decode_evsm4(cleared, nan, exponents, deviations) == 0);
    CHECK(decode_evsm2(vec2(cleared), nan, T(60), T(0.01)) == 0);
    CHECK(decode_evsm4(vec4(nan), T(0.5), exponents, deviations) == 0);
    for (const T v : {infinity, -infinity, T(0)}) {
        CHECK(std::isfinite(decode_evsm4(vec4(v), T(0.5), exponents, deviations)));
        CHECK(std::isfinite(decode_evsm2(vec2(v), T(0.5), T(60), T(0))));
    }
    // one caster, a deviation before the receiver
    CHECK(decode_evsm2(vec2(T(0.5), T(0.25)), T(0.5), T(60), T(0.5)) == T(0.5));
}

TEST_CASE("evsm: setup") {
    const evsm_parameters made = make_evsm({.exponent = 55.0f, .falling = 10.0f});
    CHECK(made.exponents == glm::vec2(55.0f, 10.0f));
    CHECK(double(made.deviations.x) == doctest::Approx(2 * 55 * std::log(2.0) * 1e-4));
    CHECK(double(made.deviations.y) == doctest::Approx(2 * 10 * std::log(2.0) * 1e-4));
    const evsm_parameters half = make_evsm({.exponent = 7.99f, .falling = 5.0f, .store = float_store::half});
    CHECK(double(half.deviations.x) == doctest::Approx(2 * 7.99 * std::log(2.0) * 1e-2));
    CHECK(encode_evsm2(1.0f, 7.99f).y < 65504.0f);  // the greatest number of 16 bits
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const evsm_settings& bad :
         {evsm_settings{.exponent = 55.5f}, evsm_settings{.falling = 55.5f}, evsm_settings{.exponent = 0.0f},
          evsm_settings{.falling = nan}, evsm_settings{.least_deviation = -1.0f}, evsm_settings{.falling = 44.0f},
          evsm_settings{.falling = 40.0f, .least_deviation = 1e-6f}, evsm_settings{.least_deviation = 1e-18f},
          evsm_settings{.least_deviation = nan}, evsm_settings{.least_deviation = infinity},
          evsm_settings{.exponent = 8.0f, .store = float_store::half}})
        CHECK_THROWS_AS((void)make_evsm(bad), std::invalid_argument);
}

TEST_CASE("evsm: where hardware takes denormals for 0, the square of a distance that is one changes no visibility") {
    const evsm_parameters p = make_evsm({.exponent = 55.0f, .falling = 43.0f});
    const float n = -exponential_warp(1.0f, -43.0f), m = n - 0x1p-64f;
    REQUIRE((n - m) * (n - m) < std::numeric_limits<float>::min());
    const float a = decode_evsm4(glm::vec4(0x1p56f, 0x1p112f, m, m * m), 1.0f, p.exponents, p.deviations);
    CHECK(std::abs(a - 1.0f) <= 0x1p-23f);
}

TEST_CASE(
    "evsm: never darker than the lit share but for rounding; four components let no more light through than two") {
    std::mt19937 random(11);
    double darker2 = 0, darker4 = 0, lighter = 0, leak2 = 0, leak4 = 0;
    const evsm_parameters p = make_evsm({.exponent = 40.0f, .falling = 40.0f});
    // of the decoder, and twice as much of rounding means to floats
    const double bound = 3 * (0x1p-24 / double(p.deviations.x * p.deviations.x) + 0x1p-21);
    for (int i = 0; i < 50000; ++i) {
        const depth_window w(random);
        const glm::vec4 m(w.mean([&](float d) { return glm::dvec4(encode_evsm4(d, p.exponents)); }));
        const double two = decode_evsm2(glm::vec2(m), w.receiver, p.exponents.x, p.deviations.x);
        const double four = decode_evsm4(m, w.receiver, p.exponents, p.deviations);
        darker2 = std::max(darker2, w.lit() - two);
        darker4 = std::max(darker4, w.lit() - four);
        lighter = std::max(lighter, four - two);
        leak2 += two - w.lit(), leak4 += four - w.lit();
    }
    CHECK(darker2 <= bound);
    CHECK(darker4 <= bound);
    CHECK(lighter <= 0);
    CHECK(leak4 < leak2);
    MESSAGE("darker by at most ", bound, "; worst seen ", darker2, " and ", darker4);
}
