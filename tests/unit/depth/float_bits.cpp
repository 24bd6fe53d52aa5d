// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>

#include <umbrage/depth/float_bits.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using glm::u8vec4;

namespace {

static_assert(encode_float_bits(1.0f) == u8vec4(0, 0, 0x80, 0x3F));
static_assert(encode_float_bits(-0.0f) == u8vec4(0, 0, 0, 0x80));
static_assert(decode_float_bits(u8vec4(0, 0, 0x80, 0x3F)) == 1.0f);

std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

}  // namespace

TEST_CASE("encode_float_bits: every kind of value comes back to the bit, NaN payloads included") {
    for (std::uint32_t b :
         {0u, 1u, 0x007FFFFFu, 0x00800000u, 0x3F800000u, 0x7F7FFFFFu, 0x7F800000u, 0x7F800001u, 0x7FC12345u,
          0x80000000u, 0x80000001u, 0xBF800000u, 0xFF800000u, 0xFFC54321u, 0xFFFFFFFFu, 0x01020304u}) {
        const u8vec4 texel = encode_float_bits(std::bit_cast<float>(b));
        CHECK(texel == u8vec4(b, b >> 8, b >> 16, b >> 24));
        CHECK(bits(decode_float_bits(texel)) == b);
        CHECK(bits(decode_float_bits(load_unorm(texel))) == b);
        for (auto mode : {unorm_store::rounds, unorm_store::truncates})
            CHECK(bits(decode_float_bits(load_unorm(store_unorm(to_unorm(glm::vec4(texel)), mode)))) == b);
    }
}

TEST_CASE("decode_float_bits: samples that no texture gives count as the nearest that one does, NaN as 1") {
    CHECK(decode_float_bits(glm::vec4(-3.0f, -inf32, 128.0f / 255.0f, 63.0f / 255.0f)) == 1.0f);
    CHECK(bits(decode_float_bits(glm::vec4(2.0f, inf32, nan32, -nan32))) == 0xFFFFFFFFu);
}
