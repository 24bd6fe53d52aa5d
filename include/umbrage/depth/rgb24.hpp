// SPDX-License-Identifier: MIT
//
// Depth in three 8-bit channels: 24 bits, R most significant.
//
//     glm::u8vec3 texel = umbrage::encode_rgb24(depth);
//     float stored = umbrage::decode_rgb24(texel);
//
// Also called: pack depth to RGB8, 24-bit depth (encode_rgb24, decode_rgb24).
//
#pragma once

#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Channels from a depth.
///
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          integer channels 0..255, R most significant
/// @edge            NaN: as cleared
/// @formula         the bytes of min(floor(depth 2^24), 2^24 - 1)
/// @exactness       A
template <real T>
[[nodiscard]] constexpr glm::u8vec3 encode_rgb24(T depth, T cleared = T(1)) {
    const std::uint32_t x = to_code<24>(depth, cleared);
    return {static_cast<std::uint8_t>(x >> 16), static_cast<std::uint8_t>(x >> 8 & 0xFF),
            static_cast<std::uint8_t>(x & 0xFF)};
}

/// Depth from values read from an 8-bit texture.
///
/// @param c       as sampled, k / 255. Any rounding of that quotient gives the same depth
/// @param edge    lower_edge or upper_edge of the quantization step; the center is exact in double only.
///                For reversed depth, pass lower_edge
/// @formula       (65536 R + 256 G + B + edge) 2^-24, with R, G, B = floor(255 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-24
template <real T>
[[nodiscard]] T decode_rgb24(glm::vec<3, T> c, T edge = upper_edge<T>) {
    const glm::vec<3, T> k = from_unorm(c);
    return from_code<24>((k.x * T(256) + k.y) * T(256) + k.z, edge);
}

/// Depth from bytes.
template <real T = float>
[[nodiscard]] constexpr T decode_rgb24(glm::u8vec3 texel, T edge = upper_edge<T>) {
    return from_code<24>(T((texel.x << 16) + (texel.y << 8) + texel.z), edge);
}

namespace glsl {

inline constexpr snippet encode_rgb24{
    .name = "encode_rgb24",
    .summary = "depth to three 8-bit channels, R most significant",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_rgb24: three channels of a depth, R most significant, integers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb24(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return vec3(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
)GLSL",
};

inline constexpr snippet decode_rgb24{
    .name = "decode_rgb24",
    .summary = "three 8-bit channels, R most significant, to depth",
    .exactness = tier::a,
    .needs = list<&from_unorm>,
    .source = R"GLSL(
// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rgb24(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
)GLSL",
};

}  // namespace glsl

/// 24-bit encoding as a value.
struct rgb24 {
    using target = unorm_target<8, 3>;
    using texel = target::texel;
    static constexpr std::string_view name = "rgb24";
    static constexpr std::string_view summary = "Three channels, R most significant.";
    static constexpr const glsl::snippet* writer = &glsl::encode_rgb24;
    static constexpr const glsl::snippet* reader = &glsl::decode_rgb24;
    static constexpr store_format writes = store_format::integers;
    static constexpr int bits = 24;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 24;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< depth that a code decodes to; the center rounds from code 2^23 on

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rgb24(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rgb24(t, edge); }
    /// Depth of the values that sampling returns, as the reader's snippet computes it.
    [[nodiscard]] float decode_sampled(glm::vec4 c) const { return decode_rgb24(glm::vec3(c), edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
