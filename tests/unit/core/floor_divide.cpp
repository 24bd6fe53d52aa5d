// SPDX-License-Identifier: MIT
//
// Held against integer division: alone, and with quotients moved by as much as the docstring allows.
#include <doctest/doctest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <random>

#include <umbrage/core/floor_divide.hpp>

using namespace umbrage;

namespace {

struct fraction {
    std::uint32_t a, b;
};

/// Whole and nearly whole quotients every second time, within the stated limits.
fraction draw_fraction(std::mt19937& random) {
    constexpr std::uint32_t end = 1u << 24, most = 1u << 18;
    for (;;) {
        const auto shift = random() % 24;
        const auto b = static_cast<std::uint32_t>(1 + (random() % end >> shift));
        auto a = static_cast<std::uint32_t>(random() % end);
        if (random() % 2) a = a / b * b + static_cast<std::uint32_t>(random() % 3) - 1;
        if (a < end && a / b <= most) return {a, b};
    }
}

/// v some ulp on.
float moved_by_ulp(float v, int ulp) { return v <= 0 ? v : std::bit_cast<float>(std::bit_cast<std::int32_t>(v) + ulp); }

}  // namespace

TEST_CASE("floor_divide: integer division, in every rounding mode, in float and double") {
    std::mt19937 random(1);
    for (const int mode : {FE_TONEAREST, FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD}) {
        int wrong = 0;
        for (int i = 0; i < 200000; ++i) {
            const auto [a, b] = draw_fraction(random);
            std::fesetround(mode);
            const float q = floor_divide(static_cast<float>(a), static_cast<float>(b));
            const double wide = floor_divide(static_cast<double>(a), static_cast<double>(b));
            std::fesetround(FE_TONEAREST);
            wrong += q != static_cast<float>(a / b) || wide != static_cast<double>(a / b);
        }
        CAPTURE(mode);
        CHECK(wrong == 0);
    }
}

TEST_CASE(
    "correct_quotient: quotients up to 8 ulp off, of which bare floors are wrong, and every one that is one off") {
    std::mt19937 random(2);
    int wrong = 0, bare = 0;
    for (int i = 0; i < 400000; ++i) {
        const auto [a, b] = draw_fraction(random);
        const float x = static_cast<float>(a), y = static_cast<float>(b), wanted = static_cast<float>(a / b);
        const float guess = std::floor(moved_by_ulp(x / y, static_cast<int>(random() % 17) - 8));
        bare += guess != wanted;
        wrong += correct_quotient(guess, x, y) != wanted;
        for (const float off : {-1.0f, 0.0f, 1.0f}) wrong += correct_quotient(wanted + off, x, y) != wanted;
    }
    CHECK(wrong == 0);
    CHECK(bare > 10000);
}

TEST_CASE("floor_divide: the ends of its range") {
    constexpr float top = 0x1p24f;
    CHECK(floor_divide(0.0f, 1.0f) == 0.0f);
    CHECK(floor_divide(0.0f, top) == 0.0f);
    CHECK(floor_divide(top - 1, top) == 0.0f);
    CHECK(floor_divide(top - 1, top - 1) == 1.0f);
    CHECK(floor_divide(top - 1, 64.0f) == 262143.0f);
    CHECK(floor_divide(262144.0f, 1.0f) == 262144.0f);
    CHECK(floor_divide(256.0f * 65535.0f, 256.0f) == 65535.0f);
    static_assert(correct_quotient(3.0, 16777215.0, 5592405.0) == 3.0);
}
