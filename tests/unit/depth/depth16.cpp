// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/depth16.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "../special_values.hpp"

using namespace umbrage;

TEST_CASE("depth16: a texel is k / (2^16 - 1), to the nearest") {
    constexpr std::uint32_t most = depth16::codes - 1;
    for (std::uint32_t k = 0; k <= most; ++k) {
        const auto texel = static_cast<std::uint16_t>(k);
        const float depth = static_cast<float>(double(k) / most);
        REQUIRE(depth16{}.decode(texel) == depth);
        REQUIRE(depth16{}.encode(depth) == texel);
        REQUIRE(depth16::target::load(texel) == glm::vec4(depth, 0, 0, 0));
    }
    const float between = static_cast<float>(2.75 / most);
    CHECK(depth16{}.encode(between) == 3);
    CHECK(depth16::target::store(between, unorm_store::truncates) == 2);
    CHECK(depth16{}.encode(static_cast<float>(2.25 / most)) == 2);
}

TEST_CASE("depth16: out of range, NaN, and empty maps") {
    constexpr std::uint32_t most = depth16::codes - 1;
    const depth16 reversed{.direction = depth_direction::reversed};
    for (const float v : {1.0f, 1.5f, inf32, nan32, -nan32}) CHECK(depth16{}.encode(v) == most);
    for (const float v : {0x1p-149f, -0.0f, -1.0f, -inf32}) CHECK(depth16{}.encode(v) == 0);
    CHECK(reversed.encode(nan32) == 0);
    CHECK(depth16{}.cleared() == most);
    CHECK(reversed.cleared() == 0);
}

TEST_CASE("depth16: its error is half a step, a step where the texture truncates, and a float's rounding") {
    constexpr double step = 1.0 / (depth16::codes - 1);
    for (const unorm_store mode : {unorm_store::rounds, unorm_store::truncates}) {
        double worst = 0;
        for (int k = 0; k < 1 << 24; k += 31) {
            const float depth = static_cast<float>(k) * 0x1p-24f;
            worst = std::max(worst, std::abs(double(depth16{}.decode(depth16::target::store(depth, mode))) - depth));
        }
        const decoding_error stated = depth16{}.error(mode);
        CHECK(stated.below == stated.above);
        CHECK(worst <= stated.below);
        CHECK(worst > stated.below - 0x1p-25 - 0.01 * step);
    }
}
