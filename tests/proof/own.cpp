// SPDX-License-Identifier: MIT
//
// Encodings of our own, proved over every code and over every depth of 24 bits. All floats: `make prove`.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "codecs.hpp"

// the oracle, by hand
static_assert(proof::code_of(0.5f, 11) == 1024 && proof::code_of(1.0f, 11) == 2047 && proof::code_of(-1.0f, 11) == 0);
static_assert(proof::code_of(0x1.8p-11f, 11) == 1 && proof::code_of(0x1.fffffep-12f, 11) == 0);
static_assert(proof::code_of(0x1.fffffep-1f, 24) == 16777215 && proof::code_of(0x1p-149f, 24) == 0);
static_assert(proof::nth_float((1ull << 31) + 1) == 0x1p-149f && proof::nth_float((1ull << 31) - 2) == -0x1p-149f);

TEST_CASE_TEMPLATE_DEFINE("encode_*, decode_*: every code round-trips, whatever the store and the read do", Encoding,
                          own_codes) {
    CAPTURE(Encoding::name);
    CHECK(proof::code_failures<Encoding>(0, Encoding::codes) == 0);
}
TEST_CASE_TEMPLATE_APPLY(own_codes, proof::own_encodings);

TEST_CASE_TEMPLATE_DEFINE(
    "encode_*, decode_*: every k / 2^24 within the stated error, in order, at or below its upper edge", Encoding,
    own_lattice) {
    CAPTURE(Encoding::name);
    CHECK(proof::own_failures<Encoding>(proof::nth_depth, 0, (1 << 24) + 1) == 0);
}
TEST_CASE_TEMPLATE_APPLY(own_lattice, proof::own_encodings);

TEST_CASE_TEMPLATE_DEFINE("encode_*, decode_*: the ends of every class of floats", Encoding, own_ends) {
    CAPTURE(Encoding::name);
    constexpr std::uint64_t nan = (1 << 23) - 1, zero = 1ull << 31, all = 1ull << 32;  // boundaries among all floats
    for (std::uint64_t at : {std::uint64_t(0), nan, nan + 1, zero - (1 << 23), zero, zero + (1 << 23),
                             zero + 0x3F800000u, zero + 0x7F800000u, all})
        CHECK(proof::own_failures<Encoding>(proof::nth_float, std::max<std::uint64_t>(at, 5000) - 5000,
                                            std::min(at + 5000, all)) == 0);
}
TEST_CASE_TEMPLATE_APPLY(own_ends, proof::own_encodings);

TEST_CASE(
    "upper edge: the cleared depth decodes to 1, and nothing shadows itself through quantization; lower edges do") {
    for (float cleared : {1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
        CHECK(umbrage::decode_rg<11>(proof::stored(umbrage::encode_rg<11>(cleared), proof::unorm_store::truncates),
                                     1.0f) == 1.0f);
    std::uint64_t shadowed_upper = 0, shadowed_lower = 0;
    for (std::uint64_t n = 0; n <= 1 << 24; ++n) {
        const float depth = proof::nth_depth(n);
        const auto texel = umbrage::encode_rg<11>(depth);
        shadowed_upper += !(depth <= umbrage::decode_rg<11>(texel, umbrage::upper_edge<float>));
        shadowed_lower += !(depth <= umbrage::decode_rg<11>(texel, umbrage::lower_edge<float>));
    }
    CHECK(shadowed_upper == 0);
    CHECK(shadowed_lower == (1 << 24) + 1 - 2048);  // all but the codes' own first depths
}
