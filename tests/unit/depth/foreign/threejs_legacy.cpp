// SPDX-License-Identifier: MIT
//
// Whole formats, their worst errors and faults: tests/proof/foreign.cpp.
#include <doctest/doctest.h>

#include <cmath>

#include <umbrage/depth/foreign/threejs_legacy.hpp>

#include "../../special_values.hpp"

using namespace umbrage;

namespace {

constexpr float below_one = 0x1.fffffep-1f;

// the literal of the GLSL twin
static_assert(1.00392163f == float(256.0 / 255.0));

static_assert(encode_threejs_legacy_repaired(0.5f) == glm::u8vec4(0, 0, 0, 128));
static_assert(encode_threejs_legacy_repaired(float(0x010203) / 16777216.0f) == glm::u8vec4(0, 3, 2, 1));
static_assert(encode_threejs_legacy_repaired(1.0f) == glm::u8vec4(255));
static_assert(encode_threejs_legacy_repaired(below_one) == glm::u8vec4(0, 255, 255, 255));

}  // namespace

TEST_CASE("write_threejs_legacy: A most significant, 1 written as 256 / 255") {
    CHECK(store_unorm(write_threejs_legacy(float(0x010203) / 16777216.0f)) == glm::u8vec4(0, 3, 2, 1));
    CHECK(write_threejs_legacy(1.0f) == glm::vec4(0, 0, 0, float(256.0 / 255.0)));
    CHECK(write_threejs_legacy(0.5f).w == 0.5f * float(256.0 / 255.0));
    CHECK(decode_threejs_legacy(glm::vec4(0, 0, 0, 128.0f / 255.0f)) == 0.5f);
    CHECK(decode_threejs_legacy(glm::vec4(0, 0, 0, 1)) == 255.0f / 256.0f);
}

TEST_CASE("threejs_legacy: out of range and NaN are the ends") {
    for (float v : {1.0f, 2.0f, inf32, nan32, -nan32}) {
        CHECK(write_threejs_legacy(v) == write_threejs_legacy(1.0f));
        CHECK(encode_threejs_legacy_repaired(v) == glm::u8vec4(255));
    }
    for (float v : {0.0f, -0.0f, -1.0f, -inf32}) {
        CHECK(write_threejs_legacy(v) == glm::vec4(0));
        CHECK(encode_threejs_legacy_repaired(v) == glm::u8vec4(0));
    }
}

TEST_CASE("threejs_legacy: double and float write the same bytes on depths that binary32 holds") {
    for (int k = 0; k <= 1 << 24; k += 997) {
        const float d = float(k) / 16777216.0f;
        REQUIRE(store_unorm(write_threejs_legacy(d)) == store_unorm(write_threejs_legacy(double(d))));
        REQUIRE(encode_threejs_legacy_repaired(d) == encode_threejs_legacy_repaired(double(d)));
        const glm::u8vec4 texel = encode_threejs_legacy_repaired(d);
        REQUIRE(std::abs(decode_threejs_legacy(load_unorm<8, double>(texel)) - double(d)) <= (d < 1 ? 1e-15 : 0x1p-32));
    }
}
