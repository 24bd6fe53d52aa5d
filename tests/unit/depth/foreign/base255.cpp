// SPDX-License-Identifier: MIT
//
// The whole format, its worst error and faults: tests/proof/foreign.cpp.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <umbrage/depth/foreign/base255.hpp>

#include "../../special_values.hpp"

using namespace umbrage;

namespace {

// the literals of the GLSL twins
static_assert(0.00392156886f == float(1.0 / 255.0));
static_assert(0.0000153787005f == float(1.0 / 65025.0));
static_assert(0.0000000603086294f == float(1.0 / 16581375.0));
static_assert(decode_base255(glm::vec4(1, 0, 0, 0)) == 1.0f);
static_assert(decode_base255(glm::dvec4(0, 1, 0, 0)) == 1.0 / 255.0);

}  // namespace

TEST_CASE("write_base255: digits in base 255, 1 as nothing at all") {
    CHECK(store_unorm(write_base255(0.5)) == glm::u8vec4(127, 127, 127, 128));  // 127.5 of each kind
    CHECK(store_unorm(write_base255(2.0 / 255.0 + 3.0 / 65025.0 + 1e-9)) == glm::u8vec4(2, 3, 0, 4));
    for (float v : {0.0f, -0.0f, -1.0f, -inf32, 1.0f, 2.0f, inf32, nan32, -nan32})
        CHECK(write_base255(v) == glm::vec4(0));
}

TEST_CASE("encode_base255_repaired: whole digits in base 255, 1 as (255, 0, 0, 0)") {
    CHECK(encode_base255_repaired(0.5) == glm::u8vec4(127, 127, 127, 127));
    CHECK(encode_base255_repaired(2.0 / 255.0 + 3.0 / 65025.0 + 1e-9) == glm::u8vec4(2, 3, 0, 4));
    for (float v : {1.0f, 2.0f, inf32, nan32, -nan32}) {
        CHECK(encode_base255_repaired(v) == glm::u8vec4(255, 0, 0, 0));
        CHECK(decode_base255(load_unorm(encode_base255_repaired(v))) == 1.0f);
    }
    for (float v : {0.0f, -0.0f, -1.0f, -inf32, std::numeric_limits<float>::denorm_min()})
        CHECK(encode_base255_repaired(v) == glm::u8vec4(0));
}

TEST_CASE("encode_base255_repaired: in double the error is one last digit") {
    for (int k = 0; k <= 1 << 24; k += 997) {
        const double d = k / 16777216.0;
        REQUIRE(std::abs(decode_base255(load_unorm<8, double>(encode_base255_repaired(d))) - d) <
                1.0001 / (255.0 * 16581375.0));
    }
}
