// SPDX-License-Identifier: MIT
//
// RGBA depth format of three.js r73 to r166, to read and write its maps, and a writer without its fault. One channel
// holds a fraction, and its rounding by an 8-bit store is part of the format.
//
//     glm::u8vec4 texel = umbrage::store_unorm(umbrage::write_threejs_legacy(depth));
//     float stored = umbrage::decode_threejs_legacy(umbrage::load_unorm(texel));
//
// Largest error of any 32-bit float depth, and the faults, measured by the tests:
//
//     format             store rounds     store truncates   faults
//     legacy             2^-32, below 1   2^-32, below 1    1.0 decodes to 255/256, below smaller depths
//     legacy, repaired   2^-24            2^-24             none
//
// Also called: packDepthToRGBA, unpackRGBAToDepth before three.js r167 (write_threejs_legacy, decode_threejs_legacy);
// packing before three.js r167 without its defects (encode_threejs_legacy_repaired).
//
#pragma once

#include <cmath>
#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Values of a depth in the layout of r73 to r166: A most significant, channels scaled by 256/255.
/// @return        UNORM values
/// @edge          depth > 255/256: A exceeds 1, and the store clamps it. The format has this fault
/// @exactness     B, n = 7: S of R, G, B, A is at most 256/255 depth times 2^25, 2^18, 2^10, 3
/// @cite          three.js r73 to r166, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_threejs_legacy(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    const T x = v * T(16777216) - std::floor(v * T(16777216));
    const T y = v * T(65536) - std::floor(v * T(65536));
    const T z = v * T(256) - std::floor(v * T(256));
    return {x * T(256.0 / 255.0), (y - x * T(1.0 / 256.0)) * T(256.0 / 255.0),
            (z - y * T(1.0 / 256.0)) * T(256.0 / 255.0), (v - z * T(1.0 / 256.0)) * T(256.0 / 255.0)};
}

/// Depth from the layout of r73 to r166.
/// @formula      255/256 (A + B/2^8 + G/2^16 + R/2^24)
/// @exactness    B, n = 7
template <real T>
[[nodiscard]] constexpr T decode_threejs_legacy(glm::vec<4, T> c) {
    return c.x * T(255.0 / 4294967296.0) + c.y * T(255.0 / 16777216.0) + c.z * T(255.0 / 65536.0) +
           c.w * T(255.0 / 256.0);
}

/// Channels for readers of r73 to r166, without the fault: 24 bits, and 1 decodes to 1.
/// @return        integer channels 0..255 (to_unorm writes them), A most significant
/// @exactness     A
template <real T>
[[nodiscard]] constexpr glm::u8vec4 encode_threejs_legacy_repaired(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    if (!(v < T(1))) return glm::u8vec4(255);
    const std::uint32_t x = to_code<24>(v);
    return {0, static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>(x >> 8 & 0xFF),
            static_cast<std::uint8_t>(x >> 16)};
}

namespace glsl {

inline constexpr snippet write_threejs_legacy{
    .name = "write_threejs_legacy",
    .summary = "depth to three.js RGBA, r73 to r166",
    .exactness = tier::b,
    .operations = 7,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
UMBRAGE_HIGHP vec4 umbrage_write_threejs_legacy(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0 - floor(v * 16777216.0);
    UMBRAGE_HIGHP float y = v * 65536.0 - floor(v * 65536.0);
    UMBRAGE_HIGHP float z = v * 256.0 - floor(v * 256.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = vec4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
)GLSL",
};

inline constexpr snippet decode_threejs_legacy{
    .name = "decode_threejs_legacy",
    .summary = "three.js RGBA, r73 to r166, to depth",
    .exactness = tier::b,
    .operations = 7,
    .source = R"GLSL(
// umbrage_decode_threejs_legacy: depth from the RGBA format of three.js r73 to r166, as sampled
UMBRAGE_HIGHP float umbrage_decode_threejs_legacy(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) +
                                                c.z * (255.0 / 65536.0) + c.w * (255.0 / 256.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet encode_threejs_legacy_repaired{
    .name = "encode_threejs_legacy_repaired",
    .summary = "depth to three.js RGBA, r73 to r166, without its fault",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_threejs_legacy_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = floor(v * 16777216.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? vec4(0.0, low, middle, high) : vec4(255.0, 255.0, 255.0, 255.0);
}
)GLSL",
};

}  // namespace glsl

// Formats as values. The store rounds.

/// RGBA format of r73 to r166, with its fault: 1 decodes to 255/256. An empty map is cleared to texels that decode to
/// 1.
struct threejs_legacy {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "threejs_legacy";
    static constexpr std::string_view summary =
        "RGBA of three.js r73 to r166, its fault included: 1 reads back as 255/256.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_legacy;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_legacy;
    static constexpr store_format writes = store_format::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// Values that the writer returns.
    [[nodiscard]] auto write(float depth) const { return write_threejs_legacy(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_legacy(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-32, .above = 0x1p-32};
    }
    [[nodiscard]] texel cleared() const { return direction == depth_direction::forward ? texel(255) : texel(0); }
};

/// RGBA format for readers of r73 to r166, written without the fault.
struct threejs_legacy_repaired {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "threejs_legacy_repaired";
    static constexpr std::string_view summary = "For readers of three.js r73 to r166, written without the fault.";
    static constexpr const glsl::snippet* writer = &glsl::encode_threejs_legacy_repaired;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_legacy;
    static constexpr store_format writes = store_format::integers;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const {
        return encode_threejs_legacy_repaired(depth, cleared_depth(direction));
    }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_legacy(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-24, .above = 0x1p-24};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
