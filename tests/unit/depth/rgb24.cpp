// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/rgb24.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using glm::u8vec3;

namespace {

static_assert(encode_rgb24(0.0f) == u8vec3(0));
static_assert(encode_rgb24(1.0f) == u8vec3(255));
static_assert(encode_rgb24(0.5f) == u8vec3(128, 0, 0));
static_assert(encode_rgb24(float(0x010203) / 16777216.0f) == u8vec3(1, 2, 3));
static_assert(decode_rgb24(u8vec3(1, 2, 3), lower_edge<float>) == float(0x010203) / 16777216.0f);
static_assert(decode_rgb24(u8vec3(255), upper_edge<float>) == 1.0f);
static_assert(decode_rgb24(u8vec3(255)) == 1.0f);
static_assert(decode_rgb24(u8vec3(255), center<double>) == 1.0 - 0x1p-25);

}  // namespace

TEST_CASE("encode_rgb24: out of range, NaN, denormals, the last steps before 1") {
    for (float v : {0x1.fffffep-1f, 1.0f, 1.5f, inf32, nan32, -nan32}) CHECK(encode_rgb24(v) == u8vec3(255));
    for (float v : {0x1.fffffep-25f, 0x1p-149f, -0.0f, -1.0f, -inf32}) CHECK(encode_rgb24(v) == u8vec3(0));
    CHECK(encode_rgb24(0x1.fffffcp-1f) == u8vec3(255, 255, 254));
    CHECK(encode_rgb24(1.0 - 1e-15) == u8vec3(255));
}

TEST_CASE("decode_rgb24: bytes, sampled floats and sampled doubles agree") {
    for (int x = 0; x < 1 << 24; x += 4099) {
        const u8vec3 texel(x >> 16, (x >> 8) & 0xFF, x & 0xFF);
        for (float edge : {lower_edge<float>, upper_edge<float>}) {
            const float d = decode_rgb24(texel, edge);
            REQUIRE(d == (float(x) + edge) / 16777216.0f);
            REQUIRE(d == decode_rgb24(load_unorm(texel), edge));
            REQUIRE(double(d) == decode_rgb24(load_unorm<8, double>(texel), double(edge)));
        }
        REQUIRE(decode_rgb24(load_unorm<8, double>(texel), center<double>) == (x + 0.5) / 16777216.0);
        REQUIRE(decode_rgb24(load_unorm(texel)) == rgb24{}.decode(texel));
    }
}

TEST_CASE("rgb24: the encoding as a value") {
    CHECK(rgb24{}.decode(rgb24{}.encode(1.0f)) == 1.0f);
    CHECK(rgb24{}.decode(u8vec3(128, 0, 0)) == 0.5f + 0x1p-24f);
    CHECK(rgb24{.edge = lower_edge<float>}.decode(u8vec3(128, 0, 0)) == 0.5f);
}
