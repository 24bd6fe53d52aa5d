// SPDX-License-Identifier: MIT
//
// What the proofs hold every encoding to. The same checks run over the depths k / 2^24 in the tests and over all floats
// in `make prove`.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/unorm.hpp>

namespace proof {

using umbrage::unorm_store;
namespace glsl = umbrage::glsl;

inline constexpr std::array stores{unorm_store::rounds, unorm_store::truncates};

/// All floats in order: the NaNs of sign 1, -infinity .. -0, +0 .. +infinity, the NaNs of sign 0.
[[nodiscard]] constexpr float nth_float(std::uint64_t n) {
    const auto bits = static_cast<std::uint32_t>(n);
    return std::bit_cast<float>(bits < 0x80000000u ? ~bits : bits - 0x80000000u);
}

/// The lattice of 24 bits, n = 0 .. 2^24.
[[nodiscard]] constexpr float nth_depth(std::uint64_t n) { return static_cast<float>(n) / 16777216.0f; }

/// A depth's code by integers alone: nothing in common with the library's way.
[[nodiscard]] constexpr std::uint32_t code_of(float depth, int code_bits) {
    const auto bits = std::bit_cast<std::uint32_t>(depth);
    const std::uint32_t magnitude = bits & 0x7FFFFFFFu;
    if (magnitude > 0x7F800000u) return (1u << code_bits) - 1;  // NaN
    if (bits >> 31) return 0;
    if (magnitude >= 0x3F800000u) return (1u << code_bits) - 1;
    const int shift = 150 - code_bits - static_cast<int>(magnitude >> 23);  // depth = significand * 2^(exponent - 150)
    return shift > 23 ? 0 : ((magnitude & 0x7FFFFFu) | 0x800000u) >> shift;
}

/// What a texture gives back of what a shader wrote.
template <int L>
[[nodiscard]] glm::vec<L, float> stored(glm::vec<L, float> written, unorm_store store) {
    return umbrage::load_unorm8(umbrage::store_unorm8(written, store));
}
template <int L>
[[nodiscard]] glm::vec<L, float> stored(glm::vec<L, std::uint8_t> channels, unorm_store store) {
    return stored(umbrage::to_unorm(glm::vec<L, float>(channels)), store);
}

// Encodings of our own.

template <int Bits>
struct rg : umbrage::rg<Bits> {
    using texel = glm::u8vec2;
    static constexpr const glsl::snippet& encoder = glsl::encode_rg<Bits>;
    static constexpr const glsl::snippet& decoder = glsl::decode_rg<Bits>;
    static texel of_code(std::uint32_t x) { return texel(x & 0xFF, (x >> 8) * (1u << (16 - Bits))); }
    static texel encode(float depth) { return umbrage::encode_rg<Bits>(depth); }
    template <class From, class T>
    static T decode(From from, T edge) {
        return umbrage::decode_rg<Bits>(from, edge);
    }
    static bool table_agrees(float depth) {
        static const auto table = umbrage::make_rg_table<Bits>();
        return umbrage::encode_rg_table<Bits>([](int x) { return table[std::size_t(x)]; }, depth) == encode(depth);
    }
};

struct rgb24 : umbrage::rgb24 {
    using texel = glm::u8vec3;
    static constexpr const glsl::snippet& encoder = glsl::encode_rgb24;
    static constexpr const glsl::snippet& decoder = glsl::decode_rgb24;
    static texel of_code(std::uint32_t x) { return texel(x / 65536, x / 256 % 256, x % 256); }
    static texel encode(float depth) { return umbrage::encode_rgb24(depth); }
    template <class From, class T>
    static T decode(From from, T edge) {
        return umbrage::decode_rgb24(from, edge);
    }
    static bool table_agrees(float) { return true; }
};

using own = std::tuple<rg<9>, rg<10>, rg<11>, rg<12>, rg<13>, rg<14>, rg<15>, rg<16>, rgb24>;

/// How many of the inputs n = first .. last - 1 break a promise: the code; the same texel through the table; each edge on
/// its side and within the stated error; 1 decodes to 1; order, also against the input before the first.
template <class Encoding>
[[nodiscard]] std::uint64_t own_failures(float (*input)(std::uint64_t), std::uint64_t first, std::uint64_t last) {
    constexpr double step = Encoding::max_error;
    const auto upper_edge = [](float depth) { return Encoding::decode(Encoding::encode(depth), 1.0f); };
    float previous = first > 0 && !umbrage::is_nan(input(first - 1)) ? upper_edge(input(first - 1)) : 0.0f;
    std::uint64_t failures = 0;
    for (std::uint64_t n = first; n < last; ++n) {
        const float given = input(n);
        const bool nan = umbrage::is_nan(given);
        const double depth = nan || given >= 1.0f ? 1.0 : given > 0.0f ? double(given) : 0.0;
        const auto texel = Encoding::encode(given);
        const float upper = Encoding::decode(texel, 1.0f), lower = Encoding::decode(texel, 0.0f);
        const double centre = Encoding::decode(texel, 0.5);
        const bool good = texel == Encoding::of_code(code_of(given, Encoding::bits)) && Encoding::table_agrees(given) &&
                          lower <= depth && depth <= upper && depth - lower <= step && upper - depth <= step &&
                          std::abs(centre - depth) <= step / 2 && (depth < 1.0 || upper == 1.0f) &&
                          (nan || previous <= upper);
        failures += !good;
        previous = nan ? 0.0f : upper;
    }
    return failures;
}

/// How many of the codes first .. last - 1 break a promise: every place in the code's interval but its end encodes as the
/// code again; what an 8-bit target keeps, rounding or truncating, and reads off by ulp decode as the bytes do.
template <class Encoding>
[[nodiscard]] std::uint64_t code_failures(std::uint64_t first, std::uint64_t last) {
    std::uint64_t failures = 0;
    for (std::uint64_t n = first; n < last; ++n) {
        const auto x = static_cast<std::uint32_t>(n);
        const auto texel = Encoding::of_code(x);
        const float lower = Encoding::decode(texel, 0.0f), upper = Encoding::decode(texel, 1.0f);
        bool good = lower == float(x) / float(Encoding::codes) && upper == float(x + 1) / float(Encoding::codes) &&
                    Encoding::encode(lower) == texel &&
                    Encoding::encode(std::bit_cast<float>(std::bit_cast<std::uint32_t>(upper) - 1)) == texel;
        for (auto store : stores) {
            const auto sampled = stored(texel, store);
            good = good && Encoding::decode(sampled, 0.0f) == lower && Encoding::decode(sampled, 1.0f) == upper;
        }
        for (int ulp : {-4096, -1, 1, 4096}) {
            auto sampled = umbrage::load_unorm8(texel);
            for (int i = 0; i < sampled.length(); ++i)
                if (sampled[i] > 0.0f || ulp > 0)
                    sampled[i] = std::bit_cast<float>(static_cast<std::uint32_t>(std::bit_cast<std::int32_t>(sampled[i]) + ulp));
            good = good && Encoding::decode(sampled, 1.0f) == upper;
        }
        failures += !good;
    }
    return failures;
}

// Formats of others, with what is known of them.

/// Of depths in (0, 1): worst error over all floats, pairs of neighbours out of order; where the store rounds, truncates.
struct facts {
    std::array<double, 2> error;
    std::array<std::uint64_t, 2> disorder_of_floats, disorder_of_lattice;
    float one;  ///< what 1 decodes to
};

struct threejs_rgba {
    static constexpr const glsl::snippet& encoder = glsl::write_threejs_rgba;
    static constexpr facts known{{0x1p-32, 0x1p-32 * 256 / 255}, {0, 0}, {0, 0}, 1.0f};
    static auto write(float depth) { return umbrage::write_threejs_rgba(depth); }
    static float read(glm::vec4 c) { return umbrage::decode_threejs_rgba(c); }
};
struct threejs_rgb {
    static constexpr const glsl::snippet& encoder = glsl::write_threejs_rgb;
    static constexpr facts known{{0x1p-24, 0x1p-24 * 256 / 255}, {0, 0}, {0, 0}, 1.0f};
    static auto write(float depth) { return umbrage::write_threejs_rgb(depth); }
    static float read(glm::vec3 c) { return umbrage::decode_threejs_rgb(c); }
};
struct threejs_rg {
    static constexpr const glsl::snippet& encoder = glsl::write_threejs_rg;
    static constexpr facts known{{0x1.02p-17, 0x1p-16 * 256 / 255}, {0, 0}, {0, 0}, 1.0f};
    static auto write(float depth) { return umbrage::write_threejs_rg(depth); }
    static float read(glm::vec2 c) { return umbrage::decode_threejs_rg(c); }
};
struct threejs_legacy {
    static constexpr const glsl::snippet& encoder = glsl::write_threejs_legacy;
    static constexpr facts known{{0x1p-32, 0x1p-32}, {0, 0}, {0, 0}, 255.0f / 256.0f};
    static auto write(float depth) { return umbrage::write_threejs_legacy(depth); }
    static float read(glm::vec4 c) { return umbrage::decode_threejs_legacy(c); }
};
struct threejs_legacy_repaired {
    static constexpr const glsl::snippet& encoder = glsl::encode_threejs_legacy_repaired;
    static constexpr facts known{{0x1p-24, 0x1p-24}, {0, 0}, {0, 0}, 1.0f};
    static auto write(float depth) { return umbrage::encode_threejs_legacy_repaired(depth); }
    static float read(glm::vec4 c) { return umbrage::decode_threejs_legacy(c); }
};
struct base255 {
    static constexpr const glsl::snippet& encoder = glsl::write_base255;
    static constexpr facts known{{0x1p-23, 0x1.021p-8}, {574, 2136572}, {0, 442398}, 0.0f};
    static auto write(float depth) { return umbrage::write_base255(depth); }
    static float read(glm::vec4 c) { return umbrage::decode_base255(c); }
};
struct base255_repaired {
    static constexpr const glsl::snippet& encoder = glsl::encode_base255_repaired;
    static constexpr facts known{{0x1p-23, 0x1p-23}, {2, 2}, {0, 0}, 1.0f};
    static auto write(float depth) { return umbrage::encode_base255_repaired(depth); }
    static float read(glm::vec4 c) { return umbrage::decode_base255(c); }
};

using foreign =
    std::tuple<threejs_rgba, threejs_rgb, threejs_rg, threejs_legacy, threejs_legacy_repaired, base255, base255_repaired>;

/// What was seen of the inputs n = first .. last - 1.
struct seen {
    std::uint64_t failures = 0;  ///< beyond the stated error, or an end that is not what it should be
    std::uint64_t disorder = 0;  ///< inputs that decode below the one before
    double error = 0;            ///< worst in (0, 1)
};

template <class Format>
[[nodiscard]] seen look_at(unorm_store store, float (*input)(std::uint64_t), std::uint64_t first, std::uint64_t last) {
    const double stated = Format::known.error[store == unorm_store::truncates];
    // most floats are written as 0 or as 1: those two are read back once
    const auto zero = Format::write(0.0f), one = Format::write(1.0f);
    const float zero_read = Format::read(stored(zero, store)), one_read = Format::read(stored(one, store));
    const auto read_back = [&](float depth) {
        const auto written = Format::write(depth);
        return written == zero ? zero_read : written == one ? one_read : Format::read(stored(written, store));
    };
    float previous = first > 0 && !umbrage::is_nan(input(first - 1)) ? read_back(input(first - 1)) : 0.0f;
    seen s;
    for (std::uint64_t n = first; n < last; ++n) {
        const float depth = input(n);
        const float decoded = read_back(depth);
        if (depth > 0.0f && depth < 1.0f) {
            const double error = std::abs(double(decoded) - double(depth));
            s.error = std::max(s.error, error);
            s.failures += !(error <= stated);
        } else {
            s.failures += decoded != (depth <= 0.0f ? 0.0f : Format::known.one);  // NaN counts as 1
        }
        s.disorder += !umbrage::is_nan(depth) && decoded < previous;
        previous = umbrage::is_nan(depth) ? 0.0f : decoded;
    }
    return s;
}

}  // namespace proof
