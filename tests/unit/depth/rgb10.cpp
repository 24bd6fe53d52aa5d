// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/rgb10.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using glm::u16vec3;

namespace {

static_assert(encode_rgb10(0.5f) == u16vec3(512, 0, 0));
static_assert(encode_rgb10(float(0xABCDEF) / 16777216.0f) == u16vec3(0xABCDEF >> 14, 0xABCDEF >> 4 & 1023, 0xF * 64));
static_assert(decode_rgb10(u16vec3(1023), upper_edge<float>) == 1.0f);
static_assert(decode_rgb10(u16vec3(1023)) == 1.0f);

}  // namespace

TEST_CASE("encode_rgb10: out of range, NaN, denormals, the last steps before 1") {
    for (float v : {0x1.fffffep-1f, 1.0f, 1.5f, inf32, nan32, -nan32})
        CHECK(encode_rgb10(v) == u16vec3(1023, 1023, 960));
    for (float v : {0x1.fffffep-25f, 0x1p-149f, -0.0f, -1.0f, -inf32}) CHECK(encode_rgb10(v) == u16vec3(0));
    CHECK(encode_rgb10(0x1.fffffcp-1f) == u16vec3(1023, 1023, 896));
}

TEST_CASE("rgb10: codes in memory and as sampled decode to the ends of their interval, and are stored as they are") {
    for (int x = 0; x < 1 << 24; x += 4099) {
        const float depth = float(x) / 16777216.0f;
        const u16vec3 channels = encode_rgb10(depth);
        const rgb10::texel texel = rgb10{}.encode(depth);
        REQUIRE(rgb10::target::unpacked(texel) == channels);
        for (auto mode : {unorm_store::rounds, unorm_store::truncates})
            REQUIRE(rgb10::target::store(to_unorm<10>(glm::vec3(channels)), mode) == texel);
        for (float edge : {lower_edge<float>, upper_edge<float>}) {
            REQUIRE(rgb10{.edge = edge}.decode(texel) == (float(x) + edge) / 16777216.0f);
            REQUIRE(decode_rgb10(glm::vec3(rgb10::target::load(texel)), edge) == (float(x) + edge) / 16777216.0f);
        }
        REQUIRE(decode_rgb10(glm::vec3(rgb10::target::load(texel))) == rgb10{}.decode(texel));
    }
    CHECK(rgb10{}.decode(rgb10{}.cleared()) == 1.0f);
}
