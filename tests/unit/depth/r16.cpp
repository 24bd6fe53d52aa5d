// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/depth/r16.hpp>

#include "../special_values.hpp"

using namespace umbrage;

TEST_CASE("encode_r16: out of range, NaN, denormals, the last steps before 1") {
    for (float v : {0x1.fffffep-1f, 1.0f, 1.5f, inf32, nan32, -nan32}) CHECK(encode_r16(v) == 65535);
    for (float v : {0x1.fffffep-17f, 0x1p-149f, -0.0f, -1.0f, -inf32}) CHECK(encode_r16(v) == 0);
    CHECK(encode_r16(0.5f) == 32768);
    CHECK(encode_r16(nan32, 0.0f) == 0);
}

TEST_CASE("r16: every code, in memory and as sampled, decodes to the ends and the center of its interval") {
    for (int k = 0; k < 65536; ++k) {
        const auto texel = static_cast<std::uint16_t>(k);
        for (float edge : {lower_edge<float>, center<float>, upper_edge<float>}) {
            const float depth = (float(k) + edge) / 65536.0f;
            REQUIRE(r16{.edge = edge}.decode(texel) == depth);
            REQUIRE(decode_r16(r16::target::load(texel).x, edge) == depth);
        }
        REQUIRE(r16{}.encode(float(k) / 65536.0f) == texel);
        REQUIRE(decode_r16(texel) == r16{}.decode(texel));
        REQUIRE(decode_r16(r16::target::load(texel).x) == r16{}.decode(texel));
        REQUIRE(r16::target::store(to_unorm<16>(float(k)), unorm_store::truncates) == texel);
    }
    CHECK(r16{}.decode(r16{}.cleared()) == 1.0f);
    CHECK(r16{.direction = depth_direction::reversed}.decode(r16{.direction = depth_direction::reversed}.cleared()) ==
          0.0f);
}
