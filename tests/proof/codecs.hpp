// SPDX-License-Identifier: MIT
//
// Checks that every encoding must pass. The tests run them over the depths k / 2^24, and `make prove` over all floats.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <type_traits>

#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/rg_table.hpp>

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

/// Values that a texture returns for values that a shader wrote.
template <int L>
[[nodiscard]] glm::vec<L, float> stored(glm::vec<L, float> written, unorm_store store) {
    return umbrage::load_unorm(umbrage::store_unorm(written, store));
}
template <int L>
[[nodiscard]] glm::vec<L, float> stored(glm::vec<L, std::uint8_t> channels, unorm_store store) {
    return stored(umbrage::to_unorm(glm::vec<L, float>(channels)), store);
}

/// Encodings of the list for which `Kind` holds.
template <template <class> class Kind, class... Encodings>
auto select_encodings(umbrage::list_of<Encodings...>)
    -> decltype(std::tuple_cat(std::conditional_t<Kind<Encodings>::value, std::tuple<Encodings>, std::tuple<>>()...));
template <template <class> class Kind>
using encodings_that = decltype(select_encodings<Kind>(umbrage::encodings{}));

// Encodings that answer for an edge of a code's interval: our own, of so many bits.

template <class Encoding>
using is_own = std::bool_constant<umbrage::has_edge<Encoding>>;
using own_encodings = encodings_that<is_own>;

/// The encoding whose codes decode to this edge.
template <class Encoding>
Encoding with_edge(float edge) {
    Encoding encoding;
    encoding.edge = edge;
    return encoding;
}

/// The texel of a code: that of its lower edge, a float for codes of up to 24 bits. Unit tests know the layouts.
template <class Encoding>
typename Encoding::texel of_code(std::uint32_t x) {
    return Encoding{}.encode(static_cast<float>(x) / static_cast<float>(Encoding::codes));
}

/// The integers that a shader makes values of.
template <class Encoding>
auto channels_of(typename Encoding::texel t) {
    using target = typename Encoding::target;
    if constexpr (requires { target::unpacked(t); }) return glm::vec3(target::unpacked(t));
    else if constexpr (target::channels == 1) return float(t);
    else return glm::vec<target::channels, float>(t);
}

template <int Bits>
bool table_agrees(const umbrage::rg<Bits>& encoding, float depth) {
    static const auto table = umbrage::make_rg_table<Bits>();
    return umbrage::encode_rg_table<Bits>([](int x) { return table[std::size_t(x)]; }, depth) == encoding.encode(depth);
}
template <class Encoding>
bool table_agrees(const Encoding&, float) {
    return true;
}

/// Number of inputs n = first .. last - 1 that break a promise: the code; the same texel through the table; each edge
/// on its side and within the stated error; 1 decodes to 1; order, also against the input before the first.
template <class Encoding>
[[nodiscard]] std::uint64_t own_failures(float (*input)(std::uint64_t), std::uint64_t first, std::uint64_t last) {
    const auto at_lower = with_edge<Encoding>(0.0f), at_center = with_edge<Encoding>(0.5f),
               at_upper = with_edge<Encoding>(1.0f);
    const double step = at_upper.error().above;
    const auto upper_edge = [&](float depth) { return at_upper.decode(at_upper.encode(depth)); };
    float previous = first > 0 && !umbrage::is_nan(input(first - 1)) ? upper_edge(input(first - 1)) : 0.0f;
    std::uint64_t failures = 0;
    for (std::uint64_t n = first; n < last; ++n) {
        const float given = input(n);
        const bool nan = umbrage::is_nan(given);
        const double depth = nan || given >= 1.0f ? 1.0 : given > 0.0f ? double(given) : 0.0;
        const auto texel = at_upper.encode(given);
        const float upper = at_upper.decode(texel), lower = at_lower.decode(texel);
        // Of 24 bits a center is no float: unit tests decode it in double.
        const double center = Encoding::bits < 24 ? at_center.decode(texel) : (double(lower) + double(upper)) / 2;
        const bool good = texel == of_code<Encoding>(code_of(given, Encoding::bits)) && table_agrees(at_upper, given) &&
                          lower <= depth && depth <= upper && depth - lower <= step && upper - depth <= step &&
                          std::abs(center - depth) <= step / 2 && (depth < 1.0 || upper == 1.0f) &&
                          (nan || previous <= upper);
        failures += !good;
        previous = nan ? 0.0f : upper;
    }
    return failures;
}

/// Number of codes first .. last - 1 that break a promise: every depth in the code's interval but its end encodes as
/// the code again; what its target keeps, rounding or truncating, and reads off by ulp decode as the texel does.
template <class Encoding>
[[nodiscard]] std::uint64_t code_failures(std::uint64_t first, std::uint64_t last) {
    using target = typename Encoding::target;
    const auto at_lower = with_edge<Encoding>(0.0f), at_upper = with_edge<Encoding>(1.0f);
    std::uint64_t failures = 0;
    for (std::uint64_t n = first; n < last; ++n) {
        const auto x = static_cast<std::uint32_t>(n);
        const auto texel = of_code<Encoding>(x);
        const float lower = at_lower.decode(texel), upper = at_upper.decode(texel);
        bool good = lower == float(x) / float(Encoding::codes) && upper == float(x + 1) / float(Encoding::codes) &&
                    at_upper.encode(std::bit_cast<float>(std::bit_cast<std::uint32_t>(upper) - 1)) == texel;
        for (auto store : stores) {
            const auto values = umbrage::to_unorm<target::bits>(channels_of<Encoding>(texel));
            const glm::vec4 read = target::load(target::store(values, store));
            good = good && at_lower.decode_sampled(read) == lower && at_upper.decode_sampled(read) == upper;
        }
        constexpr int far = 1 << (20 - target::bits);
        for (int ulp : {-far, -1, 1, far}) {
            glm::vec4 read = target::load(texel);
            for (int i = 0; i < target::channels; ++i)
                if (float& c = read[i]; c > 0.0f || ulp > 0)
                    c = std::bit_cast<float>(static_cast<std::uint32_t>(std::bit_cast<std::int32_t>(c) + ulp));
            good = good && at_upper.decode_sampled(read) == upper;
        }
        failures += !good;
    }
    return failures;
}

// Formats of others, GPUs among them, and writers for their readers.

template <class Encoding>
using is_foreign = std::bool_constant<!umbrage::has_edge<Encoding> && (Encoding{}.error().above > 0)>;
using foreign = encodings_that<is_foreign>;

/// Faults of a format, for a rounding and for a truncating store: numbers of neighbors that decode out of order, among
/// all floats and in the lattice. `one` is the depth that 1 decodes to.
struct faults {
    std::array<std::uint64_t, 2> disorder_of_floats{0, 0}, disorder_of_lattice{0, 0};
    float one = 1.0f;
};
template <class Format>
inline constexpr faults faults_of{};
template <>
inline constexpr faults faults_of<umbrage::threejs_legacy>{.one = 255.0f / 256.0f};
template <>
inline constexpr faults faults_of<umbrage::base255>{{574, 2136572}, {0, 442398}, 0.0f};
template <>
inline constexpr faults faults_of<umbrage::base255_repaired>{{2, 2}, {0, 0}, 1.0f};

/// Texture with the result of the writer's snippet.
template <class Format>
[[nodiscard]] auto texel_written(const Format& format, float depth, unorm_store store) {
    if constexpr (Format::writes == umbrage::store_format::depth) {
        return Format::target::store(umbrage::saturate(depth), store);  // by the depth pass itself
    } else if constexpr (Format::writes == umbrage::store_format::values) {
        return Format::target::store(format.write(depth), store);
    } else {
        const auto bytes = format.encode(depth);
        return umbrage::store_unorm(umbrage::to_unorm(glm::vec<bytes.length(), float>(bytes)), store);
    }
}

/// Results for the inputs n = first .. last - 1.
struct seen {
    std::uint64_t failures = 0;  ///< beyond the stated error, or an end that is not what it should be
    std::uint64_t disorder = 0;  ///< inputs that decode below the one before
    double error = 0;            ///< worst in (0, 1)
};

template <class Format>
[[nodiscard]] seen look_at(unorm_store store, float (*input)(std::uint64_t), std::uint64_t first, std::uint64_t last) {
    const Format format;
    const double stated = format.error(store).above;
    // most floats are written as 0 or as 1: those two are read back once
    const auto zero = texel_written(format, 0.0f, store), one = texel_written(format, 1.0f, store);
    const float zero_read = format.decode(zero), one_read = format.decode(one);
    const auto read_back = [&](float depth) {
        const auto texel = texel_written(format, depth, store);
        return texel == zero ? zero_read : texel == one ? one_read : format.decode(texel);
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
            s.failures += decoded != (depth <= 0.0f ? 0.0f : faults_of<Format>.one);  // NaN counts as 1
        }
        s.disorder += !umbrage::is_nan(depth) && decoded < previous;
        previous = umbrage::is_nan(depth) ? 0.0f : decoded;
    }
    return s;
}

}  // namespace proof
