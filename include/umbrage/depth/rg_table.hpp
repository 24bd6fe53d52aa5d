// SPDX-License-Identifier: MIT
//
// `encode_rg` through a lookup table, for hardware without enough arithmetic: a texture fetch with the depth as
// coordinate. Up to 11 bits the table is one row of 2^Bits texels. From 12 bits on it has rows of 2048 texels, the
// widest texture of 2002.
//
//     constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();  // 2048 x 1 RGBA8, B = A = 0
//     glm::u8vec2 texel = umbrage::encode_rg_table<11>([&](int x) { return table[x]; }, depth);
//
// Also called: LUT, lookup table, lookup texture (make_rg_table, encode_rg_table).
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <umbrage/depth/rg.hpp>

namespace umbrage {

/// Texels of the table, in the order of rg_table_size's rows. Up to 12 bits they can be computed at compile time with
/// every compiler's default limits.
/// @tparam Texel   glm::u8vec2 (RG8) or glm::u8vec4 (RGBA8; blue and alpha are 0)
/// @cite           the article on self-shadowing with pixel shader 1.x gives texel 256 as (255, 32, 0, 0);
///                 by its own formula, and here, it is (0, 32, 0, 0)
template <int Bits, class Texel = glm::u8vec2>
[[nodiscard]] constexpr std::array<Texel, std::size_t(1) << Bits> make_rg_table() {
    static_assert(Bits >= 9 && Bits <= 16);
    std::array<Texel, std::size_t(1) << Bits> table{};
    for (std::uint32_t x = 0; x < table.size(); ++x) {
        table[x].x = static_cast<std::uint8_t>(x & 0xFF);
        table[x].y = static_cast<std::uint8_t>((x >> 8) << (16 - Bits));
    }
    return table;
}

/// Size of the table as a texture.
template <int Bits>
inline constexpr int rg_table_width = Bits <= 11 ? 1 << Bits : 2048;
/// Size of the table, in texels.
template <int Bits>
inline const glm::ivec2 rg_table_size{rg_table_width<Bits>, (1 << Bits) / rg_table_width<Bits>};

/// Channels from a depth by one nearest fetch from the table: the texel that encode_rg<Bits> computes.
///
/// @param fetch     returns a texel of the table, from an int 0 .. 2^Bits - 1
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @edge            NaN: as cleared
/// @exactness       A
template <int Bits, real T, class Fetch>
[[nodiscard]] constexpr glm::u8vec2 encode_rg_table(Fetch&& fetch, T depth, T cleared = T(1)) {
    const auto texel = fetch(static_cast<int>(to_code<Bits>(depth, cleared)));
    return {texel.x, texel.y};
}

namespace glsl {

/// Name of the snippet of encode_rg_table<Bits>.
template <int Bits>
inline constexpr detail::short_name encode_rg_table_name("encode_rg$b_table", {{'b', Bits}});
/// GLSL text of encode_rg_table<Bits>.
template <int Bits>
[[nodiscard]] std::string encode_rg_table_text() {
    return detail::filled(R"GLSL(
// umbrage_encode_rg$b_table: two channels of a $b-bit depth code through a lookup table, integers 0..255
//   table   $w x $h texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg$b_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * $n.0), $l.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / $w.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * $w.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2($w.0, $h.0), texel));
    return vec2(k.x, k.y);
}
)GLSL",
                          {{'b', Bits},
                           {'n', 1 << Bits},
                           {'l', (1 << Bits) - 1},
                           {'w', rg_table_width<Bits>},
                           {'h', (1 << Bits) / rg_table_width<Bits>}});
}
template <int Bits>
inline constexpr snippet encode_rg_table{.name = encode_rg_table_name<Bits>.view(),
                                         .summary = "depth to two 8-bit channels through a lookup texture",
                                         .exactness = tier::a,
                                         .needs = list<&saturate, &from_unorm, &fetch_clamped>,
                                         .source = encode_rg_table_text<Bits>};

/// Snippets of the given members. Their texts are only filled in on use.
template <int... Bits>
inline constexpr const snippet* rg_table_snippets[]{&encode_rg_table<Bits>...};

}  // namespace glsl
}  // namespace umbrage
