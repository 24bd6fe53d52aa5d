// SPDX-License-Identifier: MIT
//
// Bit pattern of any 32-bit float in four 8-bit channels, R least significant.
//
//     glm::u8vec4 texel = umbrage::encode_float_bits(view_space_distance);
//     float same = umbrage::decode_float_bits(texel);
//
// Also called: floatBitsToUint into RGBA8 (encode_float_bits).
//
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Four channels from a float.
///
/// @param v       any value
/// @return        integer channels 0..255, R least significant
/// @edge          infinity, NaN: preserved, with the payload
/// @exactness     A: no arithmetic. Hardware that flushes denormals may pass them to this function as zero
template <class = void>  // only templates stay constexpr where GLM_FORCE_INTRINSICS makes vectors non-constant
[[nodiscard]] constexpr glm::u8vec4 encode_float_bits(float v) {
    const auto bits = detail::bit_cast<std::uint32_t>(v);
    return {static_cast<std::uint8_t>(bits & 0xFF), static_cast<std::uint8_t>(bits >> 8 & 0xFF),
            static_cast<std::uint8_t>(bits >> 16 & 0xFF), static_cast<std::uint8_t>(bits >> 24)};
}

/// Float from bytes.
[[nodiscard]] constexpr float decode_float_bits(glm::u8vec4 texel) {
    return detail::bit_cast<float>(std::uint32_t(texel.x) | std::uint32_t(texel.y) << 8 | std::uint32_t(texel.z) << 16 |
                                   std::uint32_t(texel.w) << 24);
}

/// Float from values read from an 8-bit texture.
/// @param c       as sampled, k / 255, in any rounding; clamped to [0, 1]
/// @edge          NaN: as 1
/// @exactness     A
[[nodiscard]] inline float decode_float_bits(glm::vec4 c) {
    glm::u8vec4 texel(0);
    for (glm::length_t i = 0; i < 4; ++i) texel[i] = static_cast<std::uint8_t>(from_unorm(saturate(c[i])));
    return decode_float_bits(texel);
}

namespace glsl {

inline constexpr snippet encode_float_bits{
    .name = "encode_float_bits",
    .summary = "bit pattern of a float to four channels, R least significant",
    .exactness = tier::a,
    .lowest = version::v300_es,
    .source = R"GLSL(
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
UMBRAGE_HIGHP vec4 umbrage_encode_float_bits(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP uint bits = floatBitsToUint(v);
    return vec4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
)GLSL",
};

inline constexpr snippet decode_float_bits{
    .name = "decode_float_bits",
    .summary = "four channels, R least significant, to the float they hold",
    .exactness = tier::a,
    .lowest = version::v300_es,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return uintBitsToFloat(r | (g << 8) | (b << 16) | (a << 24));
}
)GLSL",
};

}  // namespace glsl

/// Encoding by bit pattern as a value.
struct float_bits {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "float_bits";
    static constexpr std::string_view summary = "The bit pattern of the float itself, R least significant.";
    static constexpr const glsl::snippet* writer = &glsl::encode_float_bits;
    static constexpr const glsl::snippet* reader = &glsl::decode_float_bits;
    static constexpr store_format writes = store_format::integers;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const { return encode_float_bits(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_float_bits(t); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return {}; }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
