// SPDX-License-Identifier: MIT
//
// Depth in the three 10-bit channels of an R10G10B10A2 target: 24 bits, R most significant.
//
//     glm::u16vec3 channels = umbrage::encode_rgb10(depth);
//     float stored = umbrage::decode_rgb10(channels);
//
#pragma once

#include <cmath>

#include <glm/fwd.hpp>
#include <glm/vec3.hpp>

#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Channels from a depth.
///
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          integer channels 0..1023, R most significant; B holds the last four bits in its high bits
/// @edge            NaN: as cleared
/// @formula         10, 10 and 4 bits of min(floor(depth 2^24), 2^24 - 1), the last times 64
/// @exactness       A
template <real T>
[[nodiscard]] constexpr glm::u16vec3 encode_rgb10(T depth, T cleared = T(1)) {
    const std::uint32_t x = to_code<24>(depth, cleared);
    return {static_cast<std::uint16_t>(x >> 14), static_cast<std::uint16_t>(x >> 4 & 1023),
            static_cast<std::uint16_t>((x & 15) << 6)};
}

/// Depth from values read from a 10-bit texture.
///
/// @param c       as sampled, k / 1023. Any rounding of that quotient gives the same depth
/// @param edge    lower_edge or upper_edge of the quantization step; the center is exact in double only.
///                For reversed depth, pass lower_edge
/// @formula       (16384 R + 16 G + floor(B / 64) + edge) 2^-24, with R, G, B = floor(1023 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-24
template <real T>
[[nodiscard]] T decode_rgb10(glm::vec<3, T> c, T edge = upper_edge<T>) {
    const glm::vec<3, T> k = from_unorm<10>(c);
    return from_code<24>((k.x * T(1024) + k.y) * T(16) + std::floor(k.z * T(1.0 / 64.0)), edge);
}

/// Depth from channels.
template <real T = float>
[[nodiscard]] constexpr T decode_rgb10(glm::u16vec3 k, T edge = upper_edge<T>) {
    return from_code<24>(T((std::uint32_t(k.x) << 14) + (std::uint32_t(k.y) << 4) + (k.z >> 6)), edge);
}

namespace glsl {

inline constexpr snippet encode_rgb10{
    .name = "encode_rgb10",
    .summary = "depth to three 10-bit channels, R most significant",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb10(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 16384.0));
    UMBRAGE_HIGHP float rest = x - high * 16384.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 16.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3(high, middle, low * 64.0);
}
)GLSL",
};

inline constexpr snippet decode_rgb10{
    .name = "decode_rgb10",
    .summary = "three 10-bit channels, R most significant, to depth",
    .exactness = tier::a,
    .needs = list<&from_unorm10>,
    .source = R"GLSL(
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
UMBRAGE_HIGHP float umbrage_decode_rgb10(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
)GLSL",
};

}  // namespace glsl

/// 10-bit encoding as a value.
struct rgb10 {
    using target = unorm_target<10, 3>;
    using texel = target::texel;
    static constexpr std::string_view name = "rgb10";
    static constexpr std::string_view summary = "Three 10-bit channels of R10G10B10A2, R most significant.";
    static constexpr const glsl::snippet* writer = &glsl::encode_rgb10;
    static constexpr const glsl::snippet* reader = &glsl::decode_rgb10;
    static constexpr store_format writes = store_format::integers;
    static constexpr int bits = 24;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 24;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< depth that a code decodes to; the center rounds from code 2^23 on

    [[nodiscard]] constexpr texel encode(float depth) const {
        return target::packed(encode_rgb10(depth, cleared_depth(direction)));
    }
    [[nodiscard]] float decode(texel t) const { return decode_rgb10(target::unpacked(t), edge); }
    /// Depth of the values that sampling returns, as the reader's snippet computes it.
    [[nodiscard]] float decode_sampled(glm::vec4 c) const { return decode_rgb10(glm::vec3(c), edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
