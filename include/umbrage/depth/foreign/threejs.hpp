// SPDX-License-Identifier: MIT
//
// Depth formats of three.js r167 and later (RGBA, RGB, RG), to read and write its maps. Writers return UNORM values, as
// in three.js. The last channel holds a fraction, and how an 8-bit store rounds it is part of the format.
//
//     glm::u8vec4 texel = umbrage::store_unorm(umbrage::write_threejs_rgba(depth));
//     float stored = umbrage::decode_threejs_rgba(umbrage::load_unorm(texel));
//
// Largest error of any 32-bit float depth, measured by the tests:
//
//     format   store rounds   store truncates
//     rgba     2^-32          2^-31.99
//     rgb      2^-24          2^-23.99
//     rg       2^-16.99       2^-15.99
//
// Also called: packDepthToRGBA, unpackRGBAToDepth, three.js r167 and later (write_threejs_rgba, decode_threejs_rgba).
//
#pragma once

#include <cmath>
#include <string_view>

#include <glm/fwd.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/quantize.hpp>

namespace umbrage {

/// Values of a depth in RGBA: three bytes, R most significant, and the remaining fraction in A.
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          UNORM values
/// @edge            1: all ones. NaN: as cleared
/// @exactness       B, n = 5: S = R, G, at most 3/255 2^24 depth for B; A is exact
/// @cite            three.js r167 and later, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_threejs_rgba(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    if (!(v < T(1))) return glm::vec<4, T>(1);
    const T x = v * T(16777216);
    const T whole = std::floor(x);
    const T high = std::floor(whole * T(1.0 / 65536.0));
    const T rest = whole - high * T(65536);
    const T middle = std::floor(rest * T(1.0 / 256.0));
    return {high * T(1.0 / 255.0), middle * T(1.0 / 255.0), (rest - middle * T(256)) * T(1.0 / 255.0), x - whole};
}

/// Depth from RGBA.
/// @param c      as sampled
/// @formula      255/256 (R + G/2^8 + B/2^16) + A/2^24
/// @exactness    B, n = 7
template <real T>
[[nodiscard]] constexpr T decode_threejs_rgba(glm::vec<4, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(255.0 / 16777216.0) + c.w * T(1.0 / 16777216.0);
}

/// Values of a depth in RGB: two bytes, R most significant, and the remaining fraction in B.
/// @exactness    B, n = 3: S = R, at most 2/255 2^16 depth for G; B is exact
/// @cite         three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<3, T> write_threejs_rgb(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    if (!(v < T(1))) return glm::vec<3, T>(1);
    const T x = v * T(65536);
    const T whole = std::floor(x);
    const T high = std::floor(whole * T(1.0 / 256.0));
    return {high * T(1.0 / 255.0), (whole - high * T(256)) * T(1.0 / 255.0), x - whole};
}

/// Depth from RGB.
/// @formula      255/256 (R + G/2^8) + B/2^16
/// @exactness    B, n = 5
template <real T>
[[nodiscard]] constexpr T decode_threejs_rgb(glm::vec<3, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(1.0 / 65536.0);
}

/// Values of a depth in RG: one byte in R, and the remaining fraction in G.
/// @exactness    B, n = 1: S = R; G is exact
/// @cite         three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<2, T> write_threejs_rg(T depth, T cleared = T(1)) {
    const T v = saturate(depth, cleared);
    if (!(v < T(1))) return glm::vec<2, T>(1);
    const T x = v * T(256);
    const T whole = std::floor(x);
    return {whole * T(1.0 / 255.0), x - whole};
}

/// Depth from RG.
/// @formula      255/256 R + G/2^8
/// @exactness    B, n = 3
template <real T>
[[nodiscard]] constexpr T decode_threejs_rg(glm::vec<2, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(1.0 / 256.0);
}

namespace glsl {

inline constexpr snippet write_threejs_rgba{
    .name = "write_threejs_rgba",
    .summary = "depth to three.js RGBA, r167 and later",
    .exactness = tier::b,
    .operations = 5,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rgba: RGBA of a depth, as in three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec4 umbrage_write_threejs_rgba(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = whole - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = rest - middle * 256.0;
    UMBRAGE_HIGHP vec4 c = vec4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec4(1.0, 1.0, 1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rgba{
    .name = "decode_threejs_rgba",
    .summary = "three.js RGBA, r167 and later, to depth",
    .exactness = tier::b,
    .operations = 7,
    .source = R"GLSL(
// umbrage_decode_threejs_rgba: depth from the RGBA format of three.js r167 and later, as sampled
UMBRAGE_HIGHP float umbrage_decode_threejs_rgba(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) +
                                                c.z * (255.0 / 16777216.0) + c.w * (1.0 / 16777216.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet write_threejs_rgb{
    .name = "write_threejs_rgb",
    .summary = "depth to three.js RGB, r167 and later",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rgb: RGB of a depth, as in three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec3 umbrage_write_threejs_rgb(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 65536.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 256.0));
    UMBRAGE_HIGHP vec3 c = vec3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec3(1.0, 1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rgb{
    .name = "decode_threejs_rgb",
    .summary = "three.js RGB, r167 and later, to depth",
    .exactness = tier::b,
    .operations = 5,
    .source = R"GLSL(
// umbrage_decode_threejs_rgb: depth from the RGB format of three.js r167 and later, as sampled
UMBRAGE_HIGHP float umbrage_decode_threejs_rgb(UMBRAGE_HIGHP vec3 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet write_threejs_rg{
    .name = "write_threejs_rg",
    .summary = "depth to three.js RG, r167 and later",
    .exactness = tier::b,
    .operations = 1,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rg: RG of a depth, as in three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec2 umbrage_write_threejs_rg(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 256.0;
    UMBRAGE_HIGHP float whole = floor(x);
    return v < 1.0 ? vec2(whole * 0.00392156886, x - whole) : vec2(1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rg{
    .name = "decode_threejs_rg",
    .summary = "three.js RG, r167 and later, to depth",
    .exactness = tier::b,
    .operations = 3,
    .source = R"GLSL(
// umbrage_decode_threejs_rg: depth from the RG format of three.js r167 and later, as sampled
UMBRAGE_HIGHP float umbrage_decode_threejs_rg(UMBRAGE_HIGHP vec2 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
)GLSL",
};

}  // namespace glsl

// Formats as values. The store rounds.

/// RGBA format of three.js r167 and later.
struct threejs_rgba {
    using target = unorm_target<8, 4>;
    using texel = target::texel;
    static constexpr std::string_view name = "threejs_rgba";
    static constexpr std::string_view summary = "RGBA of three.js since r167: three bytes and a fraction.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rgba;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rgba;
    static constexpr store_format writes = store_format::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// Values that the writer returns.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rgba(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rgba(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-32 : 0x1p-32 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

/// RGB format of three.js r167 and later.
struct threejs_rgb {
    using target = unorm_target<8, 3>;
    using texel = target::texel;
    static constexpr std::string_view name = "threejs_rgb";
    static constexpr std::string_view summary = "RGB of three.js since r167: two bytes and a fraction.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rgb;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rgb;
    static constexpr store_format writes = store_format::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;

    depth_direction direction = depth_direction::forward;

    /// Values that the writer returns.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rgb(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rgb(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-24 : 0x1p-24 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

/// RG format of three.js r167 and later.
struct threejs_rg {
    using target = unorm_target<8, 2>;
    using texel = target::texel;
    static constexpr std::string_view name = "threejs_rg";
    static constexpr std::string_view summary = "RG of three.js since r167: one byte and a fraction.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rg;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rg;
    static constexpr store_format writes = store_format::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 16;

    depth_direction direction = depth_direction::forward;

    /// Values that the writer returns.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rg(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rg(load_unorm(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1.02p-17 : 0x1p-16 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
