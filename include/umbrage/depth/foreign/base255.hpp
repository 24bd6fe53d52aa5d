// SPDX-License-Identifier: MIT
//
// Base-255 RGBA packing by Aras Pranckevicius, to read and write the maps of Cesium, Babylon.js and bgfx.
//
//     float stored = umbrage::decode_base255(umbrage::load_unorm(texel));
//
// Below 1.0 the largest error is 2^-23 (1.2e-7). The format has two faults. 1.0 decodes to 0. A store that truncates
// makes errors up to 2^-7.98 (4e-3), and changes the order of nearby depths. The repaired writer has neither
// fault, and works with the same reader. Only the reader's rounding remains. Depths k / 2^24 keep their order. Two
// pairs of other neighboring floats decode out of order, by 1 ulp.
// Also called: EncodeFloatRGBA, packDepth, Aras' packing, Babylon.js pack, bgfx packFloatToRgba (write_base255,
// decode_base255); packing by 255 without its defects (encode_base255_repaired).
//
#pragma once

#include <cmath>
#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Values of a depth in base-255 RGBA.
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          UNORM values
/// @edge            1 decodes to 0, a fault of the format. NaN: as cleared
/// @formula         e_i = fract(255^i depth), each minus 1/255 of the next
/// @exactness       B, n = 6: S is at most 4 255^i depth, as fract is v - floor(v)
/// @cite            Pranckevicius: Encoding floats to RGBA - the final?, 2009 (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_base255(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    const T x = v - std::floor(v);
    const T y = v * T(255) - std::floor(v * T(255));
    const T z = v * T(65025) - std::floor(v * T(65025));
    const T w = v * T(16581375) - std::floor(v * T(16581375));
    constexpr T step = T(1.0 / 255.0);
    return {x - y * step, y - z * step, z - w * step, w};
}

/// Depth from base-255 RGBA.
/// @param c      as sampled
/// @formula      R + G/255 + B/255^2 + A/255^3
/// @exactness    B, n = 6
template <real T>
[[nodiscard]] constexpr T decode_base255(glm::vec<4, T> c) {
    return c.x + c.y * T(1.0 / 255.0) + c.z * T(1.0 / 65025.0) + c.w * T(1.0 / 16581375.0);
}

/// Channels for readers of base-255 RGBA, without the faults: the digits of depth in base 255.
/// @return        integer channels 0..255 (to_unorm writes them); 1 gives (255, 0, 0, 0)
/// @exactness     B, n = 7: S of the sum whose floor is digit i is at most 255 510^i depth
template <real T>
[[nodiscard]] glm::u8vec4 encode_base255_repaired(T depth, T cleared = T(1)) {
    T rest = saturate(depth, cleared) * T(255);
    glm::u8vec4 digits(0);
    for (glm::length_t i = 0; i < 4; ++i) {
        const T digit = std::floor(rest);
        digits[i] = static_cast<std::uint8_t>(digit);
        rest = (rest - digit) * T(255);
    }
    return digits;
}

namespace glsl {

inline constexpr snippet write_base255{
    .name = "write_base255",
    .summary = "depth to base-255 RGBA of Cesium, Babylon.js, bgfx",
    .exactness = tier::b,
    .operations = 6,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_base255: base-255 RGBA of a depth, values to write as they are. The store must round
// 1.0 reads back as 0.0. umbrage_encode_base255_repaired has neither fault
UMBRAGE_HIGHP vec4 umbrage_write_base255(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 e = vec4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c =
        vec4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
)GLSL",
};

inline constexpr snippet decode_base255{
    .name = "decode_base255",
    .summary = "base-255 RGBA to depth",
    .exactness = tier::b,
    .operations = 6,
    .source = R"GLSL(
// umbrage_decode_base255: depth from base-255 RGBA, as sampled
UMBRAGE_HIGHP float umbrage_decode_base255(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
)GLSL",
};

inline constexpr snippet encode_base255_repaired{
    .name = "encode_base255_repaired",
    .summary = "depth to base-255 RGBA without its faults",
    .exactness = tier::b,
    .operations = 7,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_base255_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = umbrage_saturate(depth) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (x - floor(x)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (y - floor(y)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (z - floor(z)) * 255.0;
    return vec4(floor(x), floor(y), floor(z), floor(w));
}
)GLSL",
};

}  // namespace glsl

/// Base-255 format as a value, with its faults. The store rounds. An empty map is cleared to texels that decode to 1.
struct base255 {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "base255";
    static constexpr std::string_view summary =
        "Base 255, as in Cesium, Babylon.js and bgfx, its fault included: 1 reads back as 0.";
    static constexpr const glsl::snippet* writer = &glsl::write_base255;
    static constexpr const glsl::snippet* reader = &glsl::decode_base255;
    static constexpr store_format writes = store_format::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// Values that the writer returns.
    [[nodiscard]] auto write(float depth) const { return write_base255(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_base255(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-23 : 0x1.021p-8;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const {
        return direction == depth_direction::forward ? texel(255, 0, 0, 0) : texel(0);
    }
};

/// Base-255 format as a value, written without the faults.
struct base255_repaired {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "base255_repaired";
    static constexpr std::string_view summary = "For readers of base 255, written without the fault.";
    static constexpr const glsl::snippet* writer = &glsl::encode_base255_repaired;
    static constexpr const glsl::snippet* reader = &glsl::decode_base255;
    static constexpr store_format writes = store_format::integers;
    static constexpr std::uint64_t codes = std::uint64_t(255) * 255 * 255 * 255 + 1;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const { return encode_base255_repaired(depth, cleared_depth(direction)); }
    [[nodiscard]] float decode(texel t) const { return decode_base255(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-23, .above = 0x1p-23};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
