// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/vsm.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <umbrage/core/unorm.hpp>

#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("vsm: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(encode_vsm(T(0.25)) == vec(T(0.25), T(0.0625)));
    CHECK(encode_vsm(T(0.25), T(0)) == vec(T(0.75), T(0.5625)));
    for (const T far : {T(0), T(1)}) CHECK(encode_vsm(nan, far) == vec(1));  // as cleared
    CHECK(encode_vsm(T(7)) == vec(1));
    CHECK(decode_vsm(vec(T(0.5), T(0.3125)), T(0.75), T(0)) == T(0.5));
    CHECK(decode_vsm(vec(T(0.5), T(0.3125)), T(0.25), T(0), T(0)) == T(0.5));  // reversed
    CHECK(decode_vsm(vec(1), T(1), T(0)) == 1);                                // what is cleared lights all
    CHECK(decode_vsm(vec(1), nan, T(0)) == 0);

    CHECK(encode_deviation(vec(T(0.5), T(0.3125))) == vec(T(0.5)));
    CHECK(encode_deviation(vec(T(0.5), T(0.2))) == vec(T(0.5), 0));
    CHECK(encode_deviation(vec(T(0.5), nan)) == vec(T(0.5), 0));
    CHECK(decode_deviation(vec(T(0.5))) == vec(T(0.5), T(0.3125)));
}

TEST_CASE("vsm: mean and deviation in four channels make nothing darker") {
    std::mt19937 random(7);
    const float least = 1e-5f;
    const double bound = (0.25 / double(least) + 4) * 0x1p-24;
    double darker = 0, error = 0;
    for (int i = 0; i < 50000; ++i) {
        const depth_window w(random);
        const glm::vec2 m(w.mean([](float d) { return glm::dvec2(encode_vsm(double(d))); }));
        const glm::vec2 held = encode_deviation(m);
        const glm::u8vec2 mean = encode_rg<16>(held.x), deviation = encode_rg<16>(held.y);
        const glm::vec4 sampled(load_unorm(mean), load_unorm(deviation));
        const float got = decode_vsm(decode_deviation_rgba8(sampled), w.receiver, least);
        const float direct = decode_vsm(m, w.receiver, least);
        darker = std::max(darker, direct - double(got));
        error = std::max(error, std::abs(got - double(direct)));
    }
    CHECK(darker <= 2 * bound);
    MESSAGE("darker by at most ", 2 * bound, "; worst seen ", darker, ", lighter ", error);
}
