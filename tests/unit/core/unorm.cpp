// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <umbrage/core/unorm.hpp>

#include "../special_values.hpp"

using namespace umbrage;

namespace {

static_assert(to_unorm(0.0f) == 0.25f / 256.0f);
static_assert(to_unorm(192.0f) == 193.0f / 256.0f);
static_assert(to_unorm(255.0f) == (257.0f * 255.0f + 64.0f) / 65536.0f && to_unorm(255.0f) < 1.00099f);

}  // namespace

TEST_CASE("to_unorm: the stored byte is the channel, whether the store rounds or truncates") {
    for (int k = 0; k < 256; ++k)
        for (auto mode : {unorm_store::rounds, unorm_store::truncates}) {
            CHECK(store_unorm(to_unorm(float(k)), mode) == k);
            CHECK(store_unorm(to_unorm(double(k)), mode) == k);
        }
}

TEST_CASE_TEMPLATE("to_unorm: other numbers than channels give values that a store clamps", T, float, double) {
    constexpr T inf = std::numeric_limits<T>::infinity();
    for (const T beyond : {T(65536), T(1e9), T(1e20), inf}) {
        CHECK(to_unorm<8>(beyond) >= T(1));
        CHECK(to_unorm<10>(beyond) >= T(1));
        CHECK(to_unorm<16>(beyond) == T(1));
        CHECK(to_unorm<16>(-beyond) < T(0));
    }
    for (const T none : {std::numeric_limits<T>::quiet_NaN(), -std::numeric_limits<T>::quiet_NaN()})
        (void)to_unorm<16>(none);  // any value, but defined
}

TEST_CASE("to_unorm: exact in binary32, and a sixth of a step away from every wrong byte") {
    for (int k = 0; k < 256; ++k) {
        const double value = to_unorm(double(k));
        CHECK(double(to_unorm(float(k))) == value);
        CHECK(value * 65536 == 257 * k + 64);  // 17 bits
        if (k < 255) CHECK(value * 255 - k < 0.5 - 1.0 / 6);
        if (k > 0) CHECK(value * 255 - k > 1.0 / 6 - 0.5);
        CHECK(value * 255 - k > 0.24);  // from truncation to the byte below
    }
}

TEST_CASE("from_unorm: the channel, from the quotient and from thousands of ulp beside it") {
    for (int k = 0; k < 256; ++k) {
        const auto bits = std::bit_cast<std::uint32_t>(float(k) / 255.0f);
        for (int off = k ? -4096 : 0; off <= 4096; ++off) {
            const float c = std::bit_cast<float>(bits + std::uint32_t(off));
            REQUIRE(from_unorm(c) == float(k));
        }
        CHECK(from_unorm(float(k) * float(1.0 / 255.0)) == float(k));
        CHECK(from_unorm(double(k) / 255.0) == double(k));
        // nearly half a step either way
        CHECK(from_unorm((float(k) + 0.49f) / 255.0f) == float(k));
        CHECK(from_unorm((float(k) - 0.49f) / 255.0f) == float(k));
    }
    CHECK(from_unorm(-0.0f) == 0.0f);
}

TEST_CASE("to_unorm, from_unorm: vectors go channel by channel") {
    const glm::vec4 k(0, 1, 128, 255);
    for (int i = 0; i < 4; ++i) {
        CHECK(to_unorm(k)[i] == to_unorm(k[i]));
        CHECK(from_unorm(k / 255.0f)[i] == k[i]);
    }
    CHECK(to_unorm(glm::vec2(3, 4)) == glm::vec2(to_unorm(3.0f), to_unorm(4.0f)));
    CHECK(from_unorm(glm::dvec3(0.2, 0.4, 1.0)) == glm::dvec3(51, 102, 255));
}

TEST_CASE("store_unorm: ties, out of range, NaN") {
    CHECK(store_unorm(0.5f) == 128);  // 127.5
    CHECK(store_unorm(0.5f, unorm_store::truncates) == 127);
    CHECK(store_unorm(0.99999994f, unorm_store::truncates) == 254);
    for (auto mode : {unorm_store::rounds, unorm_store::truncates}) {
        CHECK(store_unorm(1.0f, mode) == 255);
        CHECK(store_unorm(1.5f, mode) == 255);
        CHECK(store_unorm(inf32, mode) == 255);
        CHECK(store_unorm(0.0f, mode) == 0);
        CHECK(store_unorm(-0.0f, mode) == 0);
        CHECK(store_unorm(-1.0f, mode) == 0);
        CHECK(store_unorm(-inf32, mode) == 0);
        CHECK(store_unorm(nan32, mode) == 0);
        CHECK(store_unorm(-nan32, mode) == 0);
        CHECK(store_unorm(std::numeric_limits<float>::denorm_min(), mode) == 0);
    }
    CHECK(store_unorm(glm::vec3(0.0f, 0.2f, 1.0f)) == glm::vec<3, std::uint8_t>(0, 51, 255));
}

TEST_CASE("load_unorm: k / 255, and back") {
    for (int k = 0; k < 256; ++k) {
        const glm::vec<2, std::uint8_t> bytes(k, 255 - k);
        CHECK(load_unorm(bytes).x == float(k) / 255.0f);
        CHECK(load_unorm<8, double>(bytes).y == double(255 - k) / 255.0);
        CHECK(store_unorm(load_unorm(bytes)) == bytes);
        CHECK(from_unorm(load_unorm(bytes)) == glm::vec2(bytes));
    }
}

TEST_CASE_TEMPLATE("to_unorm of 10 and 16 bits: every channel is stored as it is, rounding or truncating, and read", T,
                   float, double) {
    const auto check = []<int Bits>(std::integral_constant<int, Bits>) {
        int wrong = 0;
        for (int k = 0; k < 1 << Bits; ++k) {
            const T value = to_unorm<Bits>(T(k));
            for (auto mode : {unorm_store::rounds, unorm_store::truncates})
                wrong += store_unorm<Bits>(value, mode) != k;
            for (const T beside : {T(-0.2), T(0.2)})  // of a step: more than a store may be off
                wrong += store_unorm<Bits>(value + beside / T(1 << Bits)) != k;
            const auto read =
                load_unorm<Bits, T>(glm::vec<2, unorm_channel<Bits>>(static_cast<unorm_channel<Bits>>(k)));
            wrong += from_unorm<Bits>(read) != glm::vec<2, T>(T(k));
            for (const T ulp : {T(-60), T(60)}) wrong += from_unorm<Bits>(read.x * (T(1) + ulp * T(0x1p-24))) != T(k);
        }
        CHECK(wrong == 0);
    };
    check(std::integral_constant<int, 10>{});
    check(std::integral_constant<int, 16>{});
}
