// SPDX-License-Identifier: MIT
//
// Depth in two 8-bit channels, 9 to 16 bits: the layout of the Radeon 8500 shadow map sample and its family.
// x has Bits = 8 + M bits:  R = low byte,  G = high bits, moved to the top of their byte,  value = R / 2^M + G.
// The sample has Bits = 11. Bits = 16 is plain two-byte depth.
//
//     glm::u8vec2 texel = umbrage::encode_rg<11>(depth);
//     float stored = umbrage::decode_rg<11>(texel);
//
// Also called: pack depth to RG8, 16-bit depth, unpack depth (encode_rg, decode_rg).
//
#pragma once

#include <cassert>
#include <string>
#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Channels from a depth.
///
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          integer channels 0..255; to_unorm turns them into values that a shader writes
/// @edge            NaN: as cleared
/// @formula         x = min(floor(depth 2^Bits), 2^Bits - 1);  R = x mod 256, G = floor(x / 256) 2^(16 - Bits)
/// @exactness       A
/// @cite            ATI Radeon SDK, ShadowMap sample, 2002: R = x & 0xFF, G = (x & 0xFF00) >> 3
template <int Bits, real T>
[[nodiscard]] constexpr glm::u8vec2 encode_rg(T depth, T cleared = T(1)) {
    static_assert(Bits >= 9 && Bits <= 16);
    const std::uint32_t x = to_code<Bits>(depth, cleared);
    return {static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>((x >> 8) << (16 - Bits))};
}

/// Depth from values read from an 8-bit texture.
///
/// @param c       as sampled, k / 255. Any rounding of that quotient gives the same depth
/// @param edge    lower_edge, center or upper_edge of the quantization step. For reversed depth, pass lower_edge
/// @return        depth
/// @edge          channels that no encoder wrote: the value of the formula, below 3/2
/// @formula       (R + 2^(Bits - 8) G + edge) 2^-Bits, with R, G = floor(255 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-Bits at an edge, 2^-(Bits + 1) at the center
template <int Bits, real T>
[[nodiscard]] T decode_rg(glm::vec<2, T> c, T edge = upper_edge<T>) {
    static_assert(Bits >= 9 && Bits <= 16);
    const glm::vec<2, T> k = from_unorm(c);
    return from_code<Bits>(k.x + k.y * T(1 << (Bits - 8)), edge);
}

/// Depth from bytes.
template <int Bits, real T = float>
[[nodiscard]] constexpr T decode_rg(glm::u8vec2 texel, T edge = upper_edge<T>) {
    static_assert(Bits >= 9 && Bits <= 16);
    return from_code<Bits>(T(texel.x + (texel.y << (Bits - 8))), edge);
}

namespace glsl {

/// Name of the snippet of encode_rg<Bits>.
template <int Bits>
inline constexpr detail::short_name encode_rg_name("encode_rg$b", {{'b', Bits}});
/// GLSL text of encode_rg<Bits>.
template <int Bits>
[[nodiscard]] std::string encode_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_encode_rg$b: two channels of a $b-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg$b(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * $n.0), $l.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * $s.0);
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}, {'l', (1 << Bits) - 1}, {'s', 1 << (16 - Bits)}});
}
template <int Bits>
inline constexpr snippet encode_rg{.name = encode_rg_name<Bits>.view(),
                                   .summary = "depth to two 8-bit channels, R the low byte",
                                   .exactness = tier::a,
                                   .needs = list<&saturate>,
                                   .source = encode_rg_text<Bits>};

/// Name of the snippet of decode_rg<Bits>.
template <int Bits>
inline constexpr detail::short_name decode_rg_name("decode_rg$b", {{'b', Bits}});
/// GLSL text of decode_rg<Bits>.
template <int Bits>
[[nodiscard]] std::string decode_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_decode_rg$b: depth from the two channels of a $b-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rg$b(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * $g.0 + edge) * (1.0 / $n.0);
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}, {'g', 1 << (Bits - 8)}});
}
template <int Bits>
inline constexpr snippet decode_rg{.name = decode_rg_name<Bits>.view(),
                                   .summary = "two 8-bit channels, R the low byte, to depth",
                                   .exactness = tier::a,
                                   .needs = list<&from_unorm>,
                                   .source = decode_rg_text<Bits>};

}  // namespace glsl

/// Two-channel encoding as a value.
template <int Bits>
struct rg {
    using target = unorm_target<8, 2>;
    using texel = target::texel;
    static constexpr glsl::detail::short_name name_text{"rg$b", {{'b', Bits}}};
    static constexpr std::string_view name = name_text.view();
    static constexpr std::string_view summary = "Two channels: R the low byte, G the rest in its high bits.";
    static constexpr const glsl::snippet* writer = &glsl::encode_rg<Bits>;
    static constexpr const glsl::snippet* reader = &glsl::decode_rg<Bits>;
    static constexpr store_format writes = store_format::integers;
    static constexpr int bits = Bits;
    static constexpr std::uint32_t codes = std::uint32_t(1) << Bits;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< depth that a code decodes to: lower_edge, center or upper_edge

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rg<Bits>(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rg<Bits>(t, edge); }
    /// Depth of the values that sampling returns, as the reader's snippet computes it.
    [[nodiscard]] float decode_sampled(glm::vec4 c) const { return decode_rg<Bits>(glm::vec2(c), edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(Bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
