// SPDX-License-Identifier: MIT
//
// Exhibits of encodings: public formulas, written again from their descriptions, and the inputs for the scores of these
// formulas and of this library.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/exponential.hpp>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/depth/foreign/threejs_legacy.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>

#include "mediump.hpp"
#include "museum.hpp"

namespace museum {

using namespace umbrage;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr auto truncates = unorm_store::truncates;
inline constexpr long depths = 1 << 24;

inline float fraction(float v) { return v - std::floor(v); }

// Base 256 as first shipped: fractions of 256^i v, each less 1/256 of the next, most significant in A.
inline vec4 encode_base_256(float v) {
    const vec4 e(fraction(v * 16777216.0f), fraction(v * 65536.0f), fraction(v * 256.0f), fraction(v));
    return {e.x, e.y - e.x / 256.0f, e.z - e.y / 256.0f, e.w - e.z / 256.0f};
}
inline float decode_base_256(vec4 c) { return c.x / 16777216.0f + c.y / 65536.0f + c.z / 256.0f + c.w; }

// There and back, on depths k / 2^20 below 1.
template <class RoundTrip>
score errors(RoundTrip f, double allowed) {
    score s;
    for (long k = 0; k < depths; k += 16) {
        const float d = float(k) / float(depths);
        s.add(double(f(d)) - double(d), allowed);
    }
    return s;
}
// Neighbors k / 2^24 that come back in the wrong order.
template <class RoundTrip>
score inversions(RoundTrip f) {
    score s;
    float last = f(0.0f);
    for (long k = 1; k <= depths; ++k) {
        const float here = f(float(k) / float(depths));
        s.add(here < last ? double(last) - double(here) : 0.0, 0.0);
        last = here;
    }
    return s;
}
template <class RoundTrip>
score at_one(RoundTrip f) {
    score s;
    s.add(double(f(1.0f)) - 1.0, 0x1p-20);
    return s;
}

inline float base_256(float d) { return decode_base_256(stored(encode_base_256(d))); }
inline float base255(float d) { return decode_base255(stored(write_base255(d))); }
inline float base255_repaired(float d) { return decode_base255(stored(encode_base255_repaired(d))); }
inline float legacy(float d) { return decode_threejs_legacy(stored(write_threejs_legacy(d))); }
inline float legacy_repaired(float d) { return decode_threejs_legacy(stored(encode_threejs_legacy_repaired(d))); }
inline float three_bytes(float d) { return decode_rgb24(stored(encode_rgb24(d)), upper_edge<float>); }
template <int Bits>
float two_bytes(float d) {
    return decode_rg<Bits>(stored(encode_rg<Bits>(d)), upper_edge<float>);
}

// Every byte as read through a division by 255 that comes out an ulp low.
template <class Read>
score bytes_an_ulp_low(Read read) {
    score s;
    for (int k = 0; k < 256; ++k) s.add(read(std::nextafter(float(k) / 255.0f, 0.0f)) - float(k), 0.0);
    return s;
}

// Depths k 2^-32 below 1/256, where the fourth channel matters.
template <class RoundTrip>
score small_depths(RoundTrip f) {
    score s;
    for (long k = 0; k < depths; k += 16) {
        const float d = float(k) * 0x1p-32f;
        s.add(double(f(d)) - double(d), 0x1p-30);
    }
    return s;
}
inline vec4 encode_base255_typo(float v) {
    const float x = fraction(v), y = fraction(v * 255.0f), z = fraction(v * 65025.0f), w = fraction(v * 160581375.0f);
    return {x - y / 255.0f, y - z / 255.0f, z - w / 255.0f, w};
}

// All 15361 half-precision depths from 0 to 1.
template <class RoundTrip>
score half_depths(RoundTrip f) {
    score s;
    for (int bits = 0; bits <= 0x3C00; ++bits) {
        const int exponent = bits >> 10, digits = bits & 0x3FF;
        const double d = exponent ? std::ldexp(1024 + digits, exponent - 25) : std::ldexp(digits, -24);
        s.add(double(f(half(d)).v) - d, 0x1p-11);
    }
    return s;
}
inline half base255_in_half(half v) {
    const auto fract = [](half x) { return x - floor(x); };
    const half step = 1.0 / 255.0, x = fract(v), y = fract(v * 255.0), z = fract(v * 65025.0),
               w = fract(v * 16581375.0);
    return (x - y * step) + (y - z * step) * step + (z - w * step) * half(1.0 / 65025.0) + w * half(1.0 / 16581375.0);
}
inline half rg11_in_half(half v) {
    return mediump::umbrage_decode_rg11(mediump::stored(mediump::umbrage_encode_rg11(v), truncates), 1.0);
}

// Depths through the 2048 x 1 table, the sampler's filter linear or nearest.
inline constexpr auto table = make_rg_table<11>();
template <class Fetch>
score through_table(Fetch fetch) {
    score s;
    for (long k = 0; k < depths; k += 64) {
        const float d = float(k) / float(depths);
        s.add((double(decode_rg<11>(stored(fetch(d)), center<float>)) - double(d)) * 2048.0, 1.0);
    }
    return s;
}
inline vec2 fetch_linear(float d) {
    const float x = d * 2048.0f - 0.5f, i = std::floor(x), f = x - i;
    const auto texel = [](float at) {
        return load_unorm(table[std::size_t(at < 0.0f ? 0.0f : (at > 2047.0f ? 2047.0f : at))]);
    };
    return texel(i) * (1.0f - f) + texel(i + 1.0f) * f;
}
inline glm::u8vec2 fetch_nearest(float d) {
    return encode_rg_table<11>([](int x) { return table[std::size_t(x)]; }, d);
}
template <class Texel>
score table_texels(Texel texel) {
    score s;
    for (int x = 0; x < 2048; ++x) s.add(decode_rg<11>(texel(x), lower_edge<float>) * 2048.0 - x, 0.0);
    return s;
}

// Every pair of a receiver in the middle of an 11-bit code and a stored code.
template <class Unpack>
score self_shadowing(Unpack unpack) {
    score s;
    for (int y = 0; y < 2048; ++y) {
        const float occluder = unpack(stored(table[std::size_t(y)]));
        for (int x = 0; x < 2048; ++x) {
            const bool lit = (float(x) + 0.5f) / 2048.0f <= occluder;
            s.add(lit == (x <= y) ? 0.0 : std::abs(x - y) + 1, 0.0);
        }
    }
    return s;
}

// Means of two texels with random 16-bit depths.
template <class Mean>
score means(Mean mean) {
    score s;
    std::uint32_t state = 1;
    for (int i = 0; i < 65536; ++i) {
        state = state * 1664525u + 1013904223u;
        const float a = float(state >> 16) / 65536.0f, b = float((state >> 4) & 0xFFFF) / 65536.0f;
        s.add(double(mean(encode_rg<16>(a), encode_rg<16>(b))) - (double(a) + double(b)) / 2.0, 0x1p-15);
    }
    return s;
}
inline float mean_of_channels(glm::u8vec2 a, glm::u8vec2 b) {
    return decode_rg<16>(stored((load_unorm(a) + load_unorm(b)) * 0.5f), lower_edge<float>);
}
inline float mean_of_depths(glm::u8vec2 a, glm::u8vec2 b) {
    return (decode_rg<16>(a, lower_edge<float>) + decode_rg<16>(b, lower_edge<float>)) * 0.5f;
}

// All pairs of bytes read by two drivers: one divides by 255, one multiplies by the rounded 1/255.
template <class Decode>
score two_drivers(Decode decode) {
    score s;
    for (int x = 0; x < 65536; ++x) {
        const vec2 k(x & 0xFF, x >> 8);
        s.add(double(decode(k / 255.0f)) - double(decode(k * (1.0f / 255.0f))), 0.0);
    }
    return s;
}

// Depths of all magnitudes, the code computed with a fused multiply-add and without.
template <class Code>
score fused_or_not(Code code) {
    score s;
    for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0x1p-8f); bits <= 0x3F800000u; bits += 61)
        s.add(double(code(std::bit_cast<float>(bits), true)) - double(code(std::bit_cast<float>(bits), false)), 0.0);
    return s;
}
inline float product_plus(float a, float b, float c, bool fused) { return fused ? std::fma(a, b, c) : a * b + c; }

inline float decode_srgb(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }
template <class Sample>
score sampled(Sample sample) {
    score s;
    for (int x = 0; x < 2048; ++x) {
        const vec2 c = stored(table[std::size_t(x)]);
        s.add(decode_rg<11>(vec2(sample(c.x), sample(c.y)), lower_edge<float>) * 2048.0 - x, 1.0);
    }
    return s;
}

// Whole texels through a target that keeps no alpha, or multiplies by it.
inline vec4 opaque(vec4 c) { return {c.x, c.y, c.z, 1.0f}; }
inline vec4 premultiplied(vec4 c) { return stored(vec4(c.x * c.w, c.y * c.w, c.z * c.w, c.w)); }
template <vec4 (*Target)(vec4)>
float legacy_through(float d) {
    return decode_threejs_legacy(Target(stored(write_threejs_legacy(d))));
}
template <vec4 (*Target)(vec4)>
float three_bytes_through(float d) {
    const vec3 c = stored(encode_rgb24(d));
    const vec4 kept = Target(vec4(c.x, c.y, c.z, 1.0f));
    return decode_rgb24(vec3(kept.x, kept.y, kept.z), upper_edge<float>);
}

// NaN of both signs: what depth a map holds where one was written.
template <class Clamp>
score nans(Clamp clamp) {
    score s;
    for (std::uint32_t payload = 1; payload < 0x800000; payload += 127)
        for (const std::uint32_t sign : {0u, 0x80000000u})
            s.add(double(clamp(std::bit_cast<float>(sign | 0x7F800000u | payload))) - 1.0, 0.0);
    return s;
}

// A light from 0.1 to 100 units: the reader's depth for a point against the one that the map holds of it.
template <class Writer>
score writer_and_reader(Writer writer) {
    score s;
    for (int i = 1; i <= 10000; ++i) {
        const float z = 0.1f + float(i) * (99.9f / 10000.0f);
        s.add(double(writer(z)) - double(linear_depth(z, 0.01f)), 0.0);
    }
    return s;
}

}  // namespace museum
