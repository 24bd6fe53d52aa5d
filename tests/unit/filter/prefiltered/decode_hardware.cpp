// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/decode_hardware.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("decode_hardware: by hand", T, float, double) {
    using vec2 = glm::vec<2, T>;
    using vec4 = glm::vec<4, T>;
    CHECK(chebyshev_hardware(T(0.25), T(0.5), T(0)) == T(0.5));
    CHECK(chebyshev_hardware(T(0.25), T(0.5), T(0.25)) == T(1) / T(3));
    CHECK(chebyshev_hardware(T(0.25), T(0.5), T(0.5)) == 0);
    CHECK(chebyshev_hardware(T(0.25), T(-0.5), T(0.5)) == 1);
    CHECK(decode_vsm_hardware(vec2(T(0.5), T(0.5)), T(0.75), T(1e-6), T(0)) == T(0.5));  // deviation 1/4
    CHECK(decode_vsm_hardware(vec2(T(0.5), T(0.5)), T(0.75), T(1e-6), T(0), T(0)) == 1);
    CHECK(decode_vsm_hardware(vec2(T(0.5), T(0)), T(0.75), T(0.0625), T(0)) == T(0.5));
    // one caster, a deviation before the receiver
    CHECK(decode_evsm2_hardware(vec2(T(0.5), T(0.25)), T(0.5), T(54), T(0.5), T(0)) == T(0.5));
    CHECK(decode_evsm4_hardware(vec4(T(0.5), T(0.25), T(-1), T(1)), T(0.5), vec2(54, 8), vec2(T(0.5)), T(0)) == T(0.5));
    for (const T none : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                         -std::numeric_limits<T>::infinity()}) {
        CHECK(decode_vsm_hardware(vec2(1, 0), none, T(1e-6), T(0)) == 0);
        CHECK(decode_evsm2_hardware(vec2(1, 1), none, T(40), T(0.01), T(0)) == 0);
        CHECK(decode_evsm4_hardware(vec4(1), none, vec2(40), vec2(T(0.01)), T(0)) == 0);
    }
}

namespace {

/// Visibility from one power's moments, in double throughout.
double lit_in_reals(glm::dvec2 m, double w, double deviation) { return chebyshev(m, w, deviation * deviation * w * w); }

}  // namespace

TEST_CASE("decode_hardware: the formula in doubles, with the library's powers, within the bounds for floats") {
    std::mt19937 random(13);
    const evsm_parameters p = make_evsm({.exponent = 40.0f, .falling = 40.0f});
    const double deviation = double(p.deviations.x), of_power = (5 + 4 * 40) * 0x1p-23;
    const double bound = 0.65 * of_power / deviation + of_power + 0x1p-24 / (deviation * deviation) + 0x1p-21;
    for (const float amount : {0.0f, 0.3f}) {
        const double keep = 1.0 - double(amount);
        double variance = 0, two = 0, four = 0;
        for (int i = 0; i < 20000; ++i) {
            const depth_window w(random);
            const auto off = [&](float got, double lit) {
                return std::abs(double(got) - reduce_light_bleeding(lit, double(amount)));
            };
            const glm::dvec2 plain = w.mean([](float d) { return glm::dvec2(d, double(d) * d); });
            const glm::vec2 held(encode_deviation(plain));
            variance = std::max(variance, off(decode_vsm_hardware(held, w.receiver, 1e-5f, amount),
                                              decode_vsm(plain, double(w.receiver), 1e-5)));
            const glm::vec4 m(w.mean([&](float d) { return glm::dvec4(encode_evsm4(d, p.exponents)); }));
            const double y = 40.0 * (double(w.receiver) * 2.0 - 1.0);
            const double growing = lit_in_reals(glm::dvec2(m.x, m.y), std::exp2(y), deviation);
            const double falling = lit_in_reals(glm::dvec2(m.z, m.w), -std::exp2(-y), deviation);
            two = std::max(
                two, off(decode_evsm2_hardware(glm::vec2(m), w.receiver, 40.0f, p.deviations.x, amount), growing));
            four = std::max(four, off(decode_evsm4_hardware(m, w.receiver, p.exponents, p.deviations, amount),
                                      std::min(growing, falling)));
        }
        // mean and deviation rounded to floats: 2^-25 of either beside the least deviation
        const double stored = 0x1p-24 / std::sqrt(1e-5) + 0x1p-20;
        CHECK(variance <= stored / keep);
        CHECK(two <= bound / keep);
        CHECK(four <= bound / keep);
        MESSAGE("worst seen ", variance, " of ", stored / keep, ", ", two, " and ", four, " of ", bound / keep);
    }
}
