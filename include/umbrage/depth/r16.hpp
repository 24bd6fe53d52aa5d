// SPDX-License-Identifier: MIT
//
// Depth in one 16-bit UNORM channel: half the memory of a float map, without packing.
//
//     std::uint16_t texel = umbrage::encode_r16(depth);
//     float stored = umbrage::decode_r16(texel);
//
#pragma once

#include <cstdint>

#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Channel from a depth.
///
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          integer 0..65535
/// @edge            NaN: as cleared
/// @formula         min(floor(65536 depth), 65535)
/// @exactness       A
template <real T>
[[nodiscard]] constexpr std::uint16_t encode_r16(T depth, T cleared = T(1)) {
    return static_cast<std::uint16_t>(to_code<16>(depth, cleared));
}

/// Depth from a value read from a 16-bit texture.
///
/// @param c       as sampled, k / 65535. Any rounding of that quotient gives the same depth
/// @param edge    lower_edge, center or upper_edge of the quantization step. For reversed depth, pass lower_edge
/// @formula       (k + edge) 2^-16, k = floor(65535 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-16, at the center 2^-17
template <real T>
[[nodiscard]] T decode_r16(T c, T edge = upper_edge<T>) {
    return from_code<16>(from_unorm<16>(c), edge);
}

/// Depth from a channel.
template <real T = float>
[[nodiscard]] constexpr T decode_r16(std::uint16_t texel, T edge = upper_edge<T>) {
    return from_code<16>(T(texel), edge);
}

namespace glsl {

inline constexpr snippet encode_r16{
    .name = "encode_r16",
    .summary = "depth to one 16-bit channel",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_r16: 16-bit channel of a depth, an integer 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP float umbrage_encode_r16(UMBRAGE_HIGHP float depth) {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
)GLSL",
};

inline constexpr snippet decode_r16{
    .name = "decode_r16",
    .summary = "one 16-bit channel to depth",
    .exactness = tier::a,
    .needs = list<&from_unorm16>,
    .source = R"GLSL(
// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_r16(UMBRAGE_HIGHP float c, UMBRAGE_HIGHP float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
)GLSL",
};

}  // namespace glsl

/// 16-bit encoding as a value.
struct r16 {
    using target = unorm_target<16, 1>;
    using texel = target::texel;
    static constexpr std::string_view name = "r16";
    static constexpr std::string_view summary = "One channel of 16 bits.";
    static constexpr const glsl::snippet* writer = &glsl::encode_r16;
    static constexpr const glsl::snippet* reader = &glsl::decode_r16;
    static constexpr store_format writes = store_format::integers;
    static constexpr int bits = 16;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 16;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< depth that a code decodes to: lower_edge, center or upper_edge

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_r16(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_r16(t, edge); }
    /// Depth of the values that sampling returns, as the reader's snippet computes it.
    [[nodiscard]] float decode_sampled(glm::vec4 c) const { return decode_r16(c.x, edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
