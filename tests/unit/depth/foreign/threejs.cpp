// SPDX-License-Identifier: MIT
//
// Whole formats, their worst errors and faults: tests/proof/foreign.cpp.
#include <doctest/doctest.h>

#include <umbrage/depth/foreign/threejs.hpp>

#include "../../special_values.hpp"

using namespace umbrage;

namespace {

// the literal of the GLSL twins
static_assert(0.00392156886f == float(1.0 / 255.0));

}  // namespace

TEST_CASE("write_threejs_rgba: bytes from R down, the fraction in A") {
    const float depth = (float(0x010203) + 0.5f) / 16777216.0f;
    CHECK(store_unorm(write_threejs_rgba(depth)) == glm::u8vec4(1, 2, 3, 128));
    CHECK(write_threejs_rgba(depth).w == 0.5f);
    CHECK(store_unorm(write_threejs_rgba(0.5f)) == glm::u8vec4(128, 0, 0, 0));
    CHECK(decode_threejs_rgba(glm::vec4(128.0f / 255.0f, 0, 0, 0)) == 0.5f);
}

TEST_CASE("write_threejs_rgb, write_threejs_rg: shorter, the fraction in the last channel") {
    CHECK(store_unorm(write_threejs_rgb((258.0f + 0.5f) / 65536.0f)) == glm::u8vec3(1, 2, 128));
    CHECK(write_threejs_rgb(258.25f / 65536.0f).z == 0.25f);
    CHECK(decode_threejs_rgb(glm::vec3(128.0f / 255.0f, 0, 0.5f)) == 0.5f + 0.5f / 65536.0f);
    CHECK(store_unorm(write_threejs_rg((3.0f + 0.5f) / 256.0f)) == glm::u8vec2(3, 128));
    CHECK(write_threejs_rg(3.25f / 256.0f).y == 0.25f);
    CHECK(decode_threejs_rg(glm::vec2(128.0f / 255.0f, 0.5f)) == 0.5f + 0.5f / 256.0f);
}

TEST_CASE("write_threejs_*: out of range and NaN are the ends") {
    for (float v : {1.0f, 2.0f, inf32, nan32, -nan32}) {
        CHECK(write_threejs_rgba(v) == glm::vec4(1));
        CHECK(write_threejs_rgb(v) == glm::vec3(1));
        CHECK(write_threejs_rg(v) == glm::vec2(1));
    }
    for (float v : {0.0f, -0.0f, -1.0f, -inf32}) {
        CHECK(write_threejs_rgba(v) == glm::vec4(0));
        CHECK(write_threejs_rgb(v) == glm::vec3(0));
        CHECK(write_threejs_rg(v) == glm::vec2(0));
    }
}

TEST_CASE("three.js formats: double and float write the same bytes on depths that binary32 holds") {
    for (int k = 0; k <= 1 << 24; k += 997) {
        const float d = float(k) / 16777216.0f;
        REQUIRE(store_unorm(write_threejs_rgba(d)) == store_unorm(write_threejs_rgba(double(d))));
        REQUIRE(store_unorm(write_threejs_rgb(d)) == store_unorm(write_threejs_rgb(double(d))));
        REQUIRE(store_unorm(write_threejs_rg(d)) == store_unorm(write_threejs_rg(double(d))));
    }
}
