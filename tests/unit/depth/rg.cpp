// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <utility>

#include <umbrage/depth/rg.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using glm::u8vec2;

namespace {

// by hand: R = x & 0xFF, G = (x & 0xFF00) >> 3
static_assert(encode_rg<11>(0.0f) == u8vec2(0, 0));
static_assert(encode_rg<11>(255.0f / 2048.0f) == u8vec2(255, 0));
static_assert(encode_rg<11>(256.0f / 2048.0f) == u8vec2(0, 32));
static_assert(encode_rg<11>(0.5f) == u8vec2(0, 128));
static_assert(encode_rg<11>(1.0f) == u8vec2(255, 224));
static_assert(encode_rg<9>(0.5f) == u8vec2(0, 128) && encode_rg<9>(1.0f) == u8vec2(255, 128));
static_assert(encode_rg<16>(0.5f) == u8vec2(0, 128) && encode_rg<16>(1.0f) == u8vec2(255, 255));
static_assert(encode_rg<16>(258.0f / 65536.0f) == u8vec2(2, 1));
static_assert(decode_rg<11>(u8vec2(0, 32), lower_edge<float>) == 0.125f);
static_assert(decode_rg<11>(u8vec2(255, 224), upper_edge<float>) == 1.0f);
static_assert(decode_rg<11>(u8vec2(255, 224)) == 1.0f && decode_rg<11, double>(u8vec2(0, 0)) == 1.0 / 2048.0);
static_assert(rg<11>::codes == 2048 && rg<16>{}.error().above == 1.0 / 65536 && rg<16>{}.error().below == 0.0);
static_assert(decode_rg<16>(u8vec2(2, 1), center<float>) == 258.5f / 65536.0f);

template <class Test>
void for_every_family_member(Test test) {
    [&]<int... M>(std::integer_sequence<int, M...>) { (test.template operator()<M + 9>(), ...); }
    (std::make_integer_sequence<int, 8>());
}

}  // namespace

TEST_CASE("encode_rg: the sample's own shifts, for every code of 11 bits") {
    for (std::uint32_t x = 0; x < 2048; ++x)
        CHECK(encode_rg<11>((float(x) + 0.5f) / 2048.0f) == u8vec2(x & 0xFF, (x & 0xFF00) >> 3));
}

TEST_CASE("encode_rg: out of range and NaN, for every number of bits") {
    for_every_family_member([]<int Bits>() {
        const u8vec2 last(255, (255 << (16 - Bits)) & 0xFF);
        for (float v : {1.0f, 2.0f, std::numeric_limits<float>::infinity(), nan32, -nan32}) {
            CHECK(encode_rg<Bits>(v) == last);
            CHECK(encode_rg<Bits>(double(v)) == last);
        }
        for (float v :
             {-0.0f, -1.0f, -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::denorm_min()})
            CHECK(encode_rg<Bits>(v) == u8vec2(0));
    });
}

TEST_CASE("decode_rg: bytes, sampled floats and sampled doubles agree, also for texels that no encoder writes") {
    for_every_family_member([]<int Bits>() {
        int differing = 0;
        float greatest = 0;
        for (int g = 0; g < 256; ++g)
            for (int r = 0; r < 256; ++r)
                for (float edge : {lower_edge<float>, center<float>, upper_edge<float>}) {
                    const u8vec2 texel(r, g);
                    const float d = decode_rg<Bits>(texel, edge);
                    differing += d != decode_rg<Bits>(load_unorm(texel), edge);
                    differing += double(d) != decode_rg<Bits>(load_unorm<8, double>(texel), double(edge));
                    differing += d != (float(r + (g << (Bits - 8))) + edge) / float(1 << Bits);
                    greatest = d > greatest ? d : greatest;
                }
        CHECK(differing == 0);
        CHECK(greatest < 1.5f);
        if (Bits == 9) CHECK(greatest == 766.0f / 512.0f);
        if (Bits == 16) CHECK(greatest == 1.0f);
    });
}

TEST_CASE("rg: the encoding as a value") {
    const rg<11> encoding{};
    CHECK(encoding.decode(encoding.encode(1.0f)) == 1.0f);
    CHECK(encoding.decode(encoding.encode(0.3f)) == 615.0f / 2048.0f);
    CHECK(rg<11>{.edge = lower_edge<float>}.decode(u8vec2(1, 0)) == 1.0f / 2048.0f);
}

TEST_CASE("decode_rg: without an edge, as the encoding as a value decodes") {
    for (const float depth : {0.0f, 0.3f, 1.0f}) {
        const u8vec2 texel = encode_rg<11>(depth);
        CHECK(decode_rg<11>(texel) == rg<11>{}.decode(texel));
        CHECK(decode_rg<11>(load_unorm(texel)) == rg<11>{}.decode(texel));
        CHECK(decode_rg<11>(load_unorm<8, double>(texel)) == double(rg<11>{}.decode(texel)));
    }
}
