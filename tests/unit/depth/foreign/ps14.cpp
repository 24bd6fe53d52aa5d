// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

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
