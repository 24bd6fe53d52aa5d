// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include <umbrage/core/scalar.hpp>

#include "../special_values.hpp"

using namespace umbrage;

namespace {

constexpr float from_bits(std::uint32_t bits) { return std::bit_cast<float>(bits); }
constexpr double from_bits64(std::uint64_t bits) { return std::bit_cast<double>(bits); }
constexpr std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }
constexpr std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }

static_assert(real<float> && real<double> && !real<int> && !real<long double>);

static_assert(saturate(0.25f) == 0.25f && saturate(0.25) == 0.25);
static_assert(saturate(from_bits(0x3F7FFFFF)) < 1.0f && saturate(from_bits(0x3F800001)) == 1.0f);

}  // namespace

TEST_CASE("saturate: the value inside [0, 1], to the bit") {
    for (float v :
         {0.0f, from_bits(1), from_bits(0x007FFFFF), from_bits(0x00800000), 0.1f, 0.5f, from_bits(0x3F7FFFFF), 1.0f})
        CHECK(bits(saturate(v)) == bits(v));
    for (double v : {0.0, from_bits64(1), 0.1, 0.5, from_bits64(0x3FEFFFFFFFFFFFFF), 1.0})
        CHECK(bits(saturate(v)) == bits(v));
}

TEST_CASE("saturate: below, above, -0, infinities") {
    for (float v : {-0.0f, -from_bits(1), -0.5f, -1e30f, -inf32}) CHECK(bits(saturate(v)) == 0u);
    for (float v : {from_bits(0x3F800001), 2.0f, 1e30f, inf32}) CHECK(saturate(v) == 1.0f);
    for (double v : {-0.0, -from_bits64(1), -1e300, -inf64}) CHECK(bits(saturate(v)) == 0u);
    for (double v : {1.0 + 1e-15, 1e300, inf64}) CHECK(saturate(v) == 1.0);
}

TEST_CASE("saturate: NaN is 1, whatever its sign, its payload, quiet or signalling") {
    for (std::uint32_t b : {0x7F800001u, 0x7FC00000u, 0x7FFFFFFFu, 0xFF800001u, 0xFFC00000u, 0xFFFFFFFFu})
        CHECK(saturate(from_bits(b)) == 1.0f);
    for (std::uint64_t b : {0x7FF0000000000001ull, 0x7FF8000000000000ull, 0xFFF0000000000001ull, 0xFFFFFFFFFFFFFFFFull})
        CHECK(saturate(from_bits64(b)) == 1.0);
}

TEST_CASE("is_nan, is_finite: on both sides of every boundary") {
    for (std::uint32_t sign : {0u, 0x80000000u}) {
        for (std::uint32_t b : {0u, 1u, 0x007FFFFFu, 0x3F800000u, 0x7F7FFFFFu}) {
            CHECK_FALSE(is_nan(from_bits(sign | b)));
            CHECK(is_finite(from_bits(sign | b)));
        }
        CHECK_FALSE(is_nan(from_bits(sign | 0x7F800000u)));
        CHECK_FALSE(is_finite(from_bits(sign | 0x7F800000u)));
        for (std::uint32_t b : {0x7F800001u, 0x7FC00000u, 0x7FFFFFFFu}) {
            CHECK(is_nan(from_bits(sign | b)));
            CHECK_FALSE(is_finite(from_bits(sign | b)));
        }
    }
    for (std::uint64_t sign : {0ull, 1ull << 63}) {
        CHECK(is_finite(from_bits64(sign | 0x7FEFFFFFFFFFFFFFull)));
        CHECK_FALSE(is_finite(from_bits64(sign | 0x7FF0000000000000ull)));
        CHECK_FALSE(is_nan(from_bits64(sign | 0x7FF0000000000000ull)));
        CHECK(is_nan(from_bits64(sign | 0x7FF0000000000001ull)));
        CHECK_FALSE(is_finite(from_bits64(sign | 0x7FFFFFFFFFFFFFFFull)));
    }
}
