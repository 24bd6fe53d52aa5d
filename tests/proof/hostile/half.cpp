// SPDX-License-Identifier: MIT
//
// Two-channel encodings of 9 to 13 bits in mediump.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>

#include <umbrage/depth/rg.hpp>

#include "mediump.hpp"

namespace {

struct path {
    int bits;
    mediump::vec2 (*encode)(half);
    half (*decode)(mediump::vec2, half);
    glm::u8vec2 (*exact)(float);
    // codes that come back wrong at the lower edge, center, upper edge, the channels written, stored and sampled in
    // half
    std::array<int, 3> wrong_codes;
    int wrong_depths;  // of the half values in [0, 1]: channels unlike those of exact arithmetic
};

template <int Bits>
glm::u8vec2 exact(float depth) {
    return umbrage::encode_rg<Bits>(depth);
}

const path paths[] = {
    {9, mediump::umbrage_encode_rg9, mediump::umbrage_decode_rg9, exact<9>, {0, 0, 0}, 0},
    {10, mediump::umbrage_encode_rg10, mediump::umbrage_decode_rg10, exact<10>, {0, 0, 0}, 0},
    {11, mediump::umbrage_encode_rg11, mediump::umbrage_decode_rg11, exact<11>, {0, 1024, 0}, 0},
    {12, mediump::umbrage_encode_rg12, mediump::umbrage_decode_rg12, exact<12>, {}, 0},
    {13, mediump::umbrage_encode_rg13, mediump::umbrage_decode_rg13, exact<13>, {}, 0},
};

}  // namespace

TEST_CASE("half: rounds to nearest even, overflows above 65504, keeps denormals") {
    CHECK(half(2049.0).v == 2048.0f);
    CHECK(half(2051.0).v == 2052.0f);
    CHECK(half(65519.0).v == 65504.0f);
    CHECK(std::isinf(half(65520.0).v));
    CHECK(half(0x1p-24).v == 0x1p-24f);
    CHECK(half(0x1p-25).v == 0.0f);
    CHECK(half(0x1.8p-25).v == 0x1p-24f);
    CHECK((half(2048.0) + half(1.0)).v == 2048.0f);
}

TEST_CASE("to_unorm, from_unorm: every byte survives mediump, whether the store rounds or truncates") {
    for (const auto store : {umbrage::unorm_store::rounds, umbrage::unorm_store::truncates})
        for (int k = 0; k < 256; ++k) {
            const mediump::vec2 read = mediump::stored({double(k), double(k)}, store);
            CHECK(mediump::umbrage_from_unorm(read.x).v == float(k));
        }
}

TEST_CASE("encode_rg, decode_rg: in mediump 11 bits hold at both edges, the center needs a twelfth bit") {
    std::printf("in mediump (binary16)    codes decoded wrong at                     half depths\n");
    std::printf("bits    codes   lower edge     center  upper edge  first at the center   encoded wrong\n");
    for (const path& p : paths) {
        const int codes = 1 << p.bits;
        std::array<int, 3> wrong{};
        int first = -1;
        for (int x = 0; x < codes; ++x) {
            const glm::u8vec2 k = p.exact(float(x) / float(codes));
            const auto store = x % 2 ? umbrage::unorm_store::rounds : umbrage::unorm_store::truncates;
            const mediump::vec2 sampled = mediump::stored({double(k.x), double(k.y)}, store);
            for (int e = 0; e < 3; ++e) {
                const double edge = e / 2.0;
                if (p.decode(sampled, edge).v == float((x + edge) / codes)) continue;
                ++wrong[std::size_t(e)];
                if (e == 1 && first < 0) first = x;
            }
        }
        // every half in [0, 1]: 0x0000 to 0x3C00, as multiples of 2^-24 first and then by exponent
        int wrong_depths = 0, depths = 0;
        for (int bits = 0; bits <= 0x3C00; ++bits, ++depths) {
            const int exponent = bits >> 10, fraction = bits & 0x3FF;
            const double depth = exponent ? std::ldexp(1024 + fraction, exponent - 25) : std::ldexp(fraction, -24);
            const mediump::vec2 channels = p.encode(half(depth));
            const glm::u8vec2 k = p.exact(float(depth));
            wrong_depths += channels.x.v != float(k.x) || channels.y.v != float(k.y);
        }
        std::printf("%4d %8d %12d %10d %11d %20d %9d of %d\n", p.bits, codes, wrong[0], wrong[1], wrong[2], first,
                    wrong_depths, depths);
        if (p.bits <= 11) {
            CHECK(wrong == p.wrong_codes);
            CHECK(wrong_depths == p.wrong_depths);
            CHECK(first == (p.bits == 11 ? 1024 : -1));
        } else {
            CHECK(wrong[0] > 0);
            CHECK(wrong[2] > 0);
        }
    }
}
