// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/depth24.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../special_values.hpp"

using namespace umbrage;

TEST_CASE("depth24: a texel is k / (2^24 - 1), to the nearest") {
    constexpr std::uint32_t most = depth24::codes - 1;
    for (std::uint32_t k = 0; k <= most; k += 97) {
        const auto texel = static_cast<std::uint32_t>(k);
        const float depth = static_cast<float>(double(k) / most);
        REQUIRE(depth24{}.decode(texel) == depth);
        REQUIRE(depth24{}.encode(depth) == texel);
        REQUIRE(depth24::target::load(texel) == glm::vec4(depth, 0, 0, 0));
    }
    const float between = static_cast<float>(2.75 / most);
    CHECK(depth24{}.encode(between) == 3);
    CHECK(depth24::target::store(between, unorm_store::truncates) == 2);
    CHECK(depth24{}.encode(static_cast<float>(2.25 / most)) == 2);
}

TEST_CASE("depth24: out of range, NaN, and empty maps") {
    constexpr std::uint32_t most = depth24::codes - 1;
    const depth24 reversed{.direction = depth_direction::reversed};
    for (const float v : {1.0f, 1.5f, inf32, nan32, -nan32}) CHECK(depth24{}.encode(v) == most);
    for (const float v : {0x1p-149f, -0.0f, -1.0f, -inf32}) CHECK(depth24{}.encode(v) == 0);
    CHECK(reversed.encode(nan32) == 0);
    CHECK(depth24{}.cleared() == most);
    CHECK(reversed.cleared() == 0);
}

TEST_CASE("depth24: its error is half a step, a step where the texture truncates, and a float's rounding") {
    constexpr double step = 1.0 / (depth24::codes - 1);
    for (const unorm_store mode : {unorm_store::rounds, unorm_store::truncates}) {
        double worst = 0;
        for (int k = 0; k < 1 << 24; k += 31) {
            const float depth = static_cast<float>(k) * 0x1p-24f;
            worst = std::max(worst, std::abs(double(depth24{}.decode(depth24::target::store(depth, mode))) - depth));
        }
        const decoding_error stated = depth24{}.error(mode);
        CHECK(stated.below == stated.above);
        CHECK(worst <= stated.below);
        CHECK(worst > stated.below - 0x1p-25 - 0.01 * step);
    }
}

TEST_CASE("depth24: a stencil in the high bits changes no depth") {
    CHECK(depth24{}.decode(0xFF000000u) == 0.0f);
    CHECK(depth24{}.decode(0x80FFFFFFu) == 1.0f);
    CHECK(depth24{}.encode(1.0f) == 0x00FFFFFFu);
}
