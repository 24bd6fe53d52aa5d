// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg.hpp>

using namespace umbrage;

namespace {

static_assert(decode_ps14(glm::vec2(0, 0)) == 0.0f);
static_assert(decode_ps14(glm::vec2(1, 0)) == 0.125f);
static_assert(1.00392163f == float(256.0 / 255.0));  // the literal of the GLSL twin
static_assert(receiver_ps14(0.0f) == 0.0f && receiver_ps14(1.0f) == float(256.0 / 255.0));
static_assert(receiver_ps14(1.125f) == -1.0f);                 // beyond the far plane: lit
static_assert(receiver_ps14(-2.0) == -2.0 * (256.0 / 255.0));  // not clamped

}  // namespace

TEST_CASE("decode_ps14: x / 2040 for every code, distinct, in order, and the code can be had back") {
    float previous = -1;
    for (int x = 0; x < 2048; ++x) {
        const glm::u8vec2 texel = encode_rg<11>(float(x) / 2048.0f);
        const float u = decode_ps14(load_unorm(texel));
        CHECK(std::abs(double(u) - x / 2040.0) < 6.4e-8);
        CHECK(u > previous);
        CHECK(std::floor(u * 2040.0f + 0.5f) == float(x));
        CHECK(std::abs(decode_ps14(load_unorm<8, double>(texel)) - x / 2040.0) < 1e-15);
        previous = u;
    }
    CHECK(previous == doctest::Approx(2047.0 / 2040.0).epsilon(1e-7));
}

TEST_CASE("receiver_ps14: on the scale of decode_ps14 a depth stays within its code's interval") {
    double worst_with = 0, worst_without = 0;
    for (int k = 0; k <= 65536; ++k) {
        const float depth = float(k) / 65536.0f;
        const double stored = decode_ps14(load_unorm<8, double>(encode_rg<11>(depth)));
        worst_with = std::max(worst_with, std::abs(double(receiver_ps14(depth)) - stored));
        worst_without = std::max(worst_without, std::abs(double(depth) - stored));
    }
    CHECK(worst_with < 1.0 / 2040 + 1e-7);  // a code and one rounding
    CHECK(worst_without > 6.9 / 2040);      // the drift against a raw depth
}

TEST_CASE_TEMPLATE("fixed_ps14: 12 fractional bits between -8 and 8, a tie goes up", T, float, double) {
    constexpr T step = T(1) / T(4096);
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (int k = -32768; k < 32768; ++k) {
        const T v = T(k) * step;
        CHECK(fixed_ps14(v) == v);
        CHECK(fixed_ps14(v + T(0.49) * step) == v);
        CHECK(fixed_ps14(v - T(0.5) * step) == (k > -32768 ? v : T(-8)));
        CHECK(fixed_ps14(v - T(0.51) * step) == (k > -32768 ? v - step : T(-8)));
    }
    CHECK(fixed_ps14(std::nextafter(T(0.5) * step, T(0))) == 0);  // where adding a half would round up
    CHECK(fixed_ps14(std::nextafter(T(-0.5) * step, T(-1))) == -step);
    for (T v : {T(8), T(9), infinity, nan, -nan}) CHECK(fixed_ps14(v) == T(8) - step);
    for (T v : {T(-8), T(-9), -infinity}) CHECK(fixed_ps14(v) == T(-8));
    CHECK(fixed_ps14(std::numeric_limits<T>::denorm_min()) == 0);
    CHECK(fixed_ps14(-std::numeric_limits<T>::denorm_min()) == 0);
}

TEST_CASE("decode_fixed_ps14: every code by whole numbers, distinct and in order, channels off by 4 ulp or not") {
    const auto fixed = [](int k) { return (k * 8192 + 255) / 510; };  // the nearest to 4096 k / 255
    float previous = -1;
    double worst = 0;
    for (int x = 0; x < 2048; ++x) {
        const glm::u8vec2 texel = encode_rg<11>(float(x) / 2048.0f);
        const int expected = (fixed(texel.x) >> 3) + fixed(texel.y);
        const glm::vec2 sampled = load_unorm(texel);
        const float u = decode_fixed_ps14(sampled);
        CHECK(u * 4096.0f == float(expected));
        CHECK(decode_fixed_ps14(load_unorm<8, double>(texel)) == double(u));
        for (float ulps : {-4.0f, 4.0f}) CHECK(decode_fixed_ps14(sampled * (1.0f + ulps * 0x1p-24f)) == u);
        CHECK(u > previous);
        worst = std::max(worst, std::abs(double(u) - x / 2040.0));
        previous = u;
    }
    CHECK(worst < 1.0 / 4096);
    CHECK(worst > 0.9 / 4096);  // the dropped bits, and the rounding of the channels
}

TEST_CASE("decode_fixed_ps14: a receiver in the middle of a code is on the right side of the codes next to its own") {
    const auto stored = [](int x) { return decode_fixed_ps14(load_unorm(encode_rg<11>(float(x) / 2048.0f))); };
    for (int x = 1; x < 2047; ++x) {
        const float receiver = fixed_ps14(receiver_ps14((float(x) + 0.5f) / 2048.0f));
        CHECK(receiver <= stored(x + 1));
        CHECK(receiver > stored(x - 1));
    }
}
