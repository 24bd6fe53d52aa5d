// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <utility>

#include <umbrage/depth/rg_table.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using glm::u8vec2;
using glm::u8vec4;

namespace {

constexpr auto rgba8 = make_rg_table<11, u8vec4>();
constexpr auto rg8 = make_rg_table<11>();

/// Both tables of the sample against the encoder, while compiling.
constexpr bool tables_hold_what_the_encoder_gives() {
    for (std::size_t x = 0; x < 2048; ++x) {
        const u8vec2 texel = encode_rg<11>((float(x) + 0.5f) / 2048.0f);
        if (rg8[x] != texel || rgba8[x] != u8vec4(texel.x, texel.y, 0, 0)) return false;
    }
    return true;
}
static_assert(rgba8.size() == 2048 && rg8.size() == 2048);
static_assert(sizeof(rgba8) == 2048 * 4 && sizeof(rg8) == 2048 * 2);  // as a texture upload takes them
static_assert(tables_hold_what_the_encoder_gives());
static_assert(rgba8[256] == u8vec4(0, 32, 0, 0));  // not (255, 32, 0, 0)
static_assert(rgba8[255] == u8vec4(255, 0, 0, 0));
static_assert(rgba8[2047] == u8vec4(255, 224, 0, 0));
static_assert(encode_rg_table<11>([](int x) { return rg8[std::size_t(x)]; }, 0.125f) == u8vec2(0, 32));

template <int Bits>
void table_member() {
    static constexpr std::size_t codes = std::size_t(1) << Bits;
    const auto table = make_rg_table<Bits>();
    const auto fetch = [&](int x) { return table[std::size_t(x)]; };
    std::size_t wrong = table.size() != codes;
    for (std::size_t x = 0; x < codes; ++x) {
        wrong += table[x] != encode_rg<Bits>(float(x) / float(codes));
        wrong += encode_rg_table<Bits>(fetch, (double(x) + 0.999) / double(codes)) != table[x];
    }
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("make_rg_table: every number of bits holds what the encoder gives") {
    [&]<int... M>(std::integer_sequence<int, M...>) { (table_member<M + 9>(), ...); }
    (std::make_integer_sequence<int, 8>());
}

TEST_CASE("encode_rg_table: never fetches outside the table") {
    const auto index = [](auto depth) {
        int asked = -1;
        (void)encode_rg_table<11>([&](int x) { return asked = x, u8vec2(0); }, depth);
        return asked;
    };
    for (float v : {1.0f, 7.0f, inf32, nan32, -nan32, 0x1.fffffep-1f}) CHECK(index(v) == 2047);
    for (float v : {0.0f, -0.0f, -7.0f, -inf32, 0x1p-149f}) CHECK(index(v) == 0);
    CHECK(index(0.5) == 1024);
}
