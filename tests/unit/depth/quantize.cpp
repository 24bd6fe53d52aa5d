// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include <umbrage/depth/quantize.hpp>

#include "../special_values.hpp"

using namespace umbrage;

namespace {

constexpr float below_one = 0x1.fffffep-1f;

static_assert(to_code<11>(0.5f) == 1024 && to_code<11>(1.0f) == 2047 && to_code<11>(0.0f) == 0);
static_assert(from_code<11>(1024.0f, upper_edge<float>) == 1025.0f / 2048.0f);
static_assert(from_code<11>(2047.0f, upper_edge<float>) == 1.0f);
static_assert(from_code<11>(0.0f, lower_edge<float>) == 0.0f);
static_assert(from_code<11>(3.0f, center<float>) == 3.5f / 2048.0f);
static_assert(from_code<24>(16777214.0f, upper_edge<float>) == below_one);

template <int Bits>
void both_sides_of_every_step() {
    constexpr std::uint32_t codes = 1u << Bits;
    std::uint32_t wrong = 0;
    for (std::uint32_t x = 1; x < codes; ++x) {
        const float step = float(x) / float(codes);  // exact
        const float before = std::bit_cast<float>(std::bit_cast<std::uint32_t>(step) - 1);
        wrong += to_code<Bits>(step) != x || to_code<Bits>(before) != x - 1;
        wrong += to_code<Bits>(double(step)) != x || to_code<Bits>(double(step) - 0x1p-53) != x - 1;
    }
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("to_code: both sides of every step") {
    both_sides_of_every_step<1>();
    both_sides_of_every_step<8>();
    both_sides_of_every_step<11>();
    both_sides_of_every_step<16>();
    both_sides_of_every_step<20>();
}

TEST_CASE("to_code: out of range, infinities, NaN, denormals") {
    for (float v : {-0.0f, -1.0f, -inf32, std::numeric_limits<float>::denorm_min()}) {
        CHECK(to_code<1>(v) == 0);
        CHECK(to_code<24>(v) == 0);
    }
    for (float v : {1.0f, 1.5f, inf32, nan32, -nan32}) {
        CHECK(to_code<1>(v) == 1);
        CHECK(to_code<24>(v) == 16777215);
    }
    CHECK(to_code<24>(below_one) == 16777215);
    CHECK(to_code<23>(below_one) == 8388607);
    CHECK(to_code<24>(0x1p-24f) == 1);
    CHECK(to_code<24>(0x1.fffffep-25f) == 0);
    CHECK(to_code<11>(std::numeric_limits<double>::quiet_NaN()) == 2047);
    CHECK(to_code<11>(-std::numeric_limits<double>::infinity()) == 0);
}

TEST_CASE("from_code: the three places in an interval, float and double alike") {
    for (int x : {0, 1, 1024, 2046, 2047})
        for (float edge : {lower_edge<float>, center<float>, upper_edge<float>}) {
            CHECK(from_code<11>(float(x), edge) == (float(x) + edge) / 2048.0f);
            CHECK(double(from_code<11>(float(x), edge)) == from_code<11>(double(x), double(edge)));
        }
    // the center of 24 bits: representable below 2^23, to the nearest even from there on, exact in double
    CHECK(from_code<24>(8388607.0f, center<float>) == 8388607.5f / 16777216.0f);
    CHECK(from_code<24>(8388609.0f, center<float>) == 8388610.0f / 16777216.0f);
    CHECK(from_code<24>(8388609.0, center<double>) == 8388609.5 / 16777216.0);
}
