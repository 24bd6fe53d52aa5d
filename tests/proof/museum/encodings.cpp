// SPDX-License-Identifier: MIT
//
// Exhibits: depth in 8-bit channels.
#include "museum.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include <glm/exponential.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>

#include "mediump.hpp"

namespace {

using namespace umbrage;
using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr auto truncates = unorm_store::truncates;
constexpr long depths = 1 << 24;

float fraction(float v) { return v - std::floor(v); }

// Base 256 as first shipped: fractions of 256^i v, each less 1/256 of the next, most significant in A.
vec4 encode_base_256(float v) {
    const vec4 e(fraction(v * 16777216.0f), fraction(v * 65536.0f), fraction(v * 256.0f), fraction(v));
    return {e.x, e.y - e.x / 256.0f, e.z - e.y / 256.0f, e.w - e.z / 256.0f};
}
float decode_base_256(vec4 c) { return c.x / 16777216.0f + c.y / 65536.0f + c.z / 256.0f + c.w; }

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
// Neighbours k / 2^24 that come back in the wrong order.
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

float base_256(float d) { return decode_base_256(stored(encode_base_256(d))); }
float base255(float d) { return decode_base255(stored(write_base255(d))); }
float base255_repaired(float d) { return decode_base255(stored(encode_base255_repaired(d))); }
float legacy(float d) { return decode_threejs_legacy(stored(write_threejs_legacy(d))); }
float legacy_repaired(float d) { return decode_threejs_legacy(stored(encode_threejs_legacy_repaired(d))); }
float three_bytes(float d) { return decode_rgb24(stored(encode_rgb24(d)), upper_edge<float>); }
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
vec4 encode_base255_typo(float v) {
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
half base255_in_half(half v) {
    const auto fract = [](half x) { return x - floor(x); };
    const half step = 1.0 / 255.0, x = fract(v), y = fract(v * 255.0), z = fract(v * 65025.0), w = fract(v * 16581375.0);
    return (x - y * step) + (y - z * step) * step + (z - w * step) * half(1.0 / 65025.0) + w * half(1.0 / 16581375.0);
}
half rg11_in_half(half v) {
    return mediump::umbrage_decode_rg11(mediump::stored(mediump::umbrage_encode_rg11(v), truncates), 1.0);
}

// Depths through the 2048 x 1 table, the sampler's filter linear or nearest.
constexpr auto table = make_rg_table<11>();
template <class Fetch>
score through_table(Fetch fetch) {
    score s;
    for (long k = 0; k < depths; k += 64) {
        const float d = float(k) / float(depths);
        s.add((double(decode_rg<11>(stored(fetch(d)), centre<float>)) - double(d)) * 2048.0, 1.0);
    }
    return s;
}
vec2 fetch_linear(float d) {
    const float x = d * 2048.0f - 0.5f, i = std::floor(x), f = x - i;
    const auto texel = [](float at) { return load_unorm8(table[std::size_t(at < 0.0f ? 0.0f : (at > 2047.0f ? 2047.0f : at))]); };
    return texel(i) * (1.0f - f) + texel(i + 1.0f) * f;
}
glm::u8vec2 fetch_nearest(float d) {
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
float mean_of_channels(glm::u8vec2 a, glm::u8vec2 b) {
    return decode_rg<16>(stored((load_unorm8(a) + load_unorm8(b)) * 0.5f), lower_edge<float>);
}
float mean_of_depths(glm::u8vec2 a, glm::u8vec2 b) {
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
float product_plus(float a, float b, float c, bool fused) { return fused ? std::fma(a, b, c) : a * b + c; }

float decode_srgb(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }
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
vec4 opaque(vec4 c) { return {c.x, c.y, c.z, 1.0f}; }
vec4 premultiplied(vec4 c) { return stored(vec4(c.x * c.w, c.y * c.w, c.z * c.w, c.w)); }
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

const exhibit all[] = {
    {"1.0 decodes to 0: base 256", "old bgfx, Godot and Mapbox GL packers",
     "The cleared far plane comes back as the nearest depth: everything that sees it is in shadow.",
     "e_i = fract(256^i v), each less e_(i+1) / 256", "depth 1, back more than 2^-20 off", "depth",
     "`encode_rgb24` clamps the code, not the fraction: code 2^24 - 1, whose upper edge is 1",
     [] { return at_one(base_256); }, [] { return at_one(three_bytes); }},
    {"1.0 decodes to 0: base 255", "Aras Pranckevicius' formula of 2009 as used by Cesium, Babylon.js, bgfx",
     "The same, for the packer that is most copied.", "e_i = fract(255^i v), each less e_(i+1) / 255",
     "depth 1, back more than 2^-20 off", "depth",
     "`encode_base255_repaired` writes digits instead of fractions, for the same reader", [] { return at_one(base255); },
     [] { return at_one(base255_repaired); }},
    {"Nothing above 255/256", "three.js r73 to r166, lygia",
     "The top channel would need 256/255 and is clamped: the far plane comes back nearer than depths in front of it.",
     "fract packing scaled by 256/255, read with 255/256", "depth 1, back more than 2^-20 off", "depth",
     "`encode_threejs_legacy_repaired` writes all ones for 1, for the same reader", [] { return at_one(legacy); },
     [] { return at_one(legacy_repaired); }},
    {"Depths in the wrong order", "old bgfx, Godot and Mapbox GL packers",
     "The channels are no multiples of 1/255, the store rounds them, and a farther depth comes back nearer.",
     "e_i = fract(256^i v), each less e_(i+1) / 256", "2^24 pairs of neighbours k / 2^24, back in the wrong order", "depth",
     "`encode_rgb24` writes whole channels: monotone", [] { return inversions(base_256); },
     [] { return inversions(three_bytes); }},
    {"32 bits that hold nine", "old bgfx, Godot and Mapbox GL packers",
     "Fractions scaled for base 256 meet channels in steps of 1/255.", "e_i = fract(256^i v), each less e_(i+1) / 256",
     "depths k / 2^20, back more than 2^-23 off", "depth", "`encode_rgb24`: three whole channels, 2^-24",
     [] { return errors(base_256, 0x1p-23); }, [] { return errors(three_bytes, 0x1p-23); }},
    {"A store that truncates", "Cesium, Babylon.js, bgfx; mrdoob/three.js#28692 on rounding not being mandated",
     "Base 255 counts on the render target rounding to nearest; one that truncates loses a step of the top channel.",
     "e_i = fract(255^i v), each less e_(i+1) / 255, into a truncating target", "depths k / 2^20, back more than 2^-22 off",
     "depth", "`to_unorm` aims a quarter of a step above the channel, so that rounding and truncating agree",
     [] { return errors([](float d) { return decode_base255(stored(write_base255(d), truncates)); }, 0x1p-22); },
     [] { return errors([](float d) { return decode_base255(stored(encode_base255_repaired(d), truncates)); }, 0x1p-22); }},
    {"Two moments, truncated", "bgfx's VSM sample and three.js' pack2Half",
     "The same for 16 bits in two channels: half of them are gone.", "(v - g / 255, g), g = fract(255 v)",
     "depths k / 2^20, back more than 2^-16 off", "depth", "`encode_rg<16>` and `to_unorm`",
     [] {
         return errors(
             [](float d) {
                 const float g = fraction(255.0f * d);
                 const vec2 c = stored(vec2(d - g / 255.0f, g), truncates);
                 return c.x + c.y / 255.0f;
             },
             0x1p-16);
     },
     [] {
         return errors([](float d) { return decode_rg<16>(stored(encode_rg<16>(d), truncates), upper_edge<float>); }, 0x1p-16);
     }},
    {"Bytes read by truncation", "PlayCanvas float-as-uint; dolphin-emu/dolphin#280 met it on an Intel HD 4000",
     "A driver whose k / 255 is an ulp low turns nearly every byte into the one below.", "uint(c * 255.0)",
     "256 bytes, read an ulp low", "bytes", "`from_unorm`: floor(255 c + 1/2) stands thousands of ulp",
     [] { return bytes_an_ulp_low([](float c) { return std::floor(c * 255.0f); }); },
     [] { return bytes_an_ulp_low([](float c) { return from_unorm(c); }); }},
    {"160581375", "older Cesium builds, gists, dataset pages: a digit too many in 255^3 = 16581375",
     "The fourth channel holds noise, and small depths lose its eight bits.", "w = fract(160581375 v)",
     "depths below 1/256 in steps of 2^-28, back more than 2^-30 off", "depth",
     "constants are tested on every code; `encode_base255_repaired` multiplies by 255 four times",
     [] { return small_depths([](float d) { return decode_base255(stored(encode_base255_typo(d))); }); },
     [] { return small_depths(base255_repaired); }},
    {"mediump overflow", "mrdoob/three.js#9092 on an iPad Air 2, mapbox #10979",
     "65536 and 16581375 exceed 65504, the greatest half: the factors are infinite and the channels NaN.",
     "fract(v * vec4(1, 255, 65025, 16581375)) in mediump", "every half in [0, 1], back NaN or more than 2^-11 off", "depth",
     "snippets put highp on every value; `encode_rg11` holds in mediump too: its own GLSL text was run here",
     [] { return half_depths(base255_in_half); }, [] { return half_depths(rg11_in_half); }},
    {"The two wrong bytes", "three.js' first RG variant, mrdoob/three.js#28692, put right in #28789",
     "Sixteen bits made from the two least significant channels of four.", "(R, G) of a texel whose top channel is A",
     "depths k / 2^20, back more than 2^-15 off", "depth", "`encode_rg<16>` splits a 16-bit code",
     [] {
         return errors(
             [](float d) {
                 const vec4 c = write_threejs_legacy(d);
                 const vec2 kept = stored(vec2(c.y, c.x));
                 return (kept.x + kept.y / 256.0f) * (255.0f / 256.0f);
             },
             0x1p-15);
     },
     [] { return errors(two_bytes<16>, 0x1p-15); }},
    {"Most significant first, or last", "three.js r167 turned the order round; readers written for r166 and before kept theirs",
     "A map written R first and read A first is noise.", "written by the format of r167, read by that of r166",
     "depths k / 2^20, back more than 2^-20 off", "depth", "formats have names of their own: `write_threejs_rgba` with `decode_threejs_rgba`",
     [] { return errors([](float d) { return decode_threejs_legacy(stored(write_threejs_rgba(d))); }, 0x1p-20); },
     [] { return errors([](float d) { return decode_threejs_rgba(stored(write_threejs_rgba(d))); }, 0x1p-20); }},
    {"A look-up table with linear filter", "look-up encodings in the manner of the Radeon 8500 sample",
     "Where the low byte falls from 255 to 0 the high one rises by 32; both are interpolated, rounded to bytes, and half a step of "
     "the high one is 4 codes.",
     "texture2D(table, depth) with GL_LINEAR", "depths k / 2^18, back more than a code off", "codes",
     "`encode_rg_table` fetches one whole texel", [] { return through_table(fetch_linear); },
     [] { return through_table(fetch_nearest); }},
    {"The article's texel 256", "the article on self-shadowing with pixel shader 1.x",
     "Its text has (255, 32) where its own formula has 256 & 255 = 0: one texel out of 2048 is 255 codes off.",
     "table[256] = (255, 32)", "2048 texels of the table", "codes",
     "`make_rg_table` is computed, and compared with the encoder",
     [] { return table_texels([](int x) { return x == 256 ? glm::u8vec2(255, 32) : table[std::size_t(x)]; }); },
     [] { return table_texels([](int x) { return table[std::size_t(x)]; }); }},
    {"r / 8 + g against a raw depth", "ports of the Radeon 8500 sample",
     "r / 8 + g is x / 2040, not x / 2048: compared with an unscaled depth, shadows begin up to 8 codes too late.",
     "depth <= r / 8 + g", "2048^2 pairs of receiver and stored code, the wrong side of the test", "codes",
     "`decode_rg<11>` gives x / 2048; for the literal form there is `receiver_ps14`",
     [] { return self_shadowing([](vec2 c) { return decode_ps14(c); }); },
     [] { return self_shadowing([](vec2 c) { return decode_rg<11>(c, upper_edge<float>); }); }},
    {"Blurring packed texels", "any blur, mip level or multisample resolve of a packed map",
     "The mean of the high bytes is rounded to a byte and takes the low byte's meaning with it.",
     "mean of the channels, stored, decoded", "2^16 pairs of texels, mean more than 2^-15 off", "depth",
     "filters take a fetch of decoded depths; nothing averages channels", [] { return means(mean_of_channels); },
     [] { return means(mean_of_depths); }},
    {"Two drivers, two depths", "every decoder that multiplies sampled channels; here three.js' RG format",
     "k / 255 and k (1/255) differ by an ulp for 126 of 256 bytes, and so do the depths.",
     "255/256 R + G/256 on channels as sampled", "2^16 texels, read by a division and by a product", "depth",
     "`decode_rg<16>` makes whole bytes of the channels first", [] { return two_drivers(decode_threejs_rg<float>); },
     [] { return two_drivers([](vec2 c) { return decode_rg<16>(c, upper_edge<float>); }); }},
    {"A fused multiply-add changes the code", "24-bit packers that scale by 2^24 - 1",
     "v (2^24 - 1) + 1/2 is not representable: with contraction, on by default in GCC, the code is another.",
     "floor(v * 16777215.0 + 0.5)", "depths from 2^-8 to 1, the code with fma unlike that without", "codes",
     "`to_code<24>` scales by 2^24: nothing to round",
     [] { return fused_or_not([](float v, bool fused) { return std::floor(product_plus(v, 16777215.0f, 0.5f, fused)); }); },
     [] { return fused_or_not([](float v, bool fused) { return to_code<24>(product_plus(v, 1.0f, 0.0f, fused)); }); }},
    {"Sampled through sRGB", "packed maps in textures that the engine takes for colour",
     "The sampler bends every channel before the decoder sees it.", "decode(sRGB to linear(c))",
     "2048 codes, back more than a code off", "codes", "documented: linear formats; bytes reach `from_unorm` as they are",
     [] { return sampled(decode_srgb); }, [] { return sampled([](float c) { return c; }); }},
    {"Alpha dropped", "three.js' layout before r167, mrdoob/three.js#28692",
     "The most significant byte sits in alpha; a target without alpha reads 1 there.", "A most significant, opaque target",
     "depths k / 2^20, back more than 2^-22 off", "depth", "`encode_rgb24` and `encode_rg` leave alpha alone",
     [] { return errors(legacy_through<opaque>, 0x1p-22); }, [] { return errors(three_bytes_through<opaque>, 0x1p-22); }},
    {"Alpha premultiplied", "three.js' layout before r167, mrdoob/three.js#28692",
     "A canvas or blend that multiplies colour by alpha scales the low bytes by the high one.",
     "A most significant, premultiplied target", "depths k / 2^20, back more than 2^-22 off", "depth",
     "`encode_rgb24` and `encode_rg` leave alpha alone", [] { return errors(legacy_through<premultiplied>, 0x1p-22); },
     [] { return errors(three_bytes_through<premultiplied>, 0x1p-22); }},
    {"NaN becomes the nearest depth", "clamps written as comparisons; PlayCanvas 9124 met NaN depths in its maps",
     "One degenerate triangle, and its texel shadows everything.", "v > 0 ? min(v, 1) : 0",
     "NaN of either sign, stored as less than 1", "depth", "`saturate` makes NaN of either sign 1, the cleared depth",
     [] { return nans([](float v) { return v > 0.0f ? (v < 1.0f ? v : 1.0f) : 0.0f; }); },
     [] { return nans([](float v) { return saturate(v); }); }},
    {"Written as z/w, read as distance", "cocos/cocos-engine#8397, packed against linear depth",
     "The map holds perspective depth, the reader compares linear depth: half the map's range is the first 0.2 units.",
     "store z/w; compare z / z_far", "10000 points, the two depths unlike", "depth",
     "kinds of depth are named: `linear_depth` on both sides", [] {
         return writer_and_reader([](float z) { return depth_from_view_z(z, 0.1f, 100.0f); });
     },
     [] { return writer_and_reader([](float z) { return linear_depth(z, 0.01f); }); }},
};

}  // namespace

std::span<const exhibit> encodings() { return all; }
