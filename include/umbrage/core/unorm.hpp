// SPDX-License-Identifier: MIT
//
// Conversion between integer channels and the values of UNORM render targets with 8, 10 or 16 bits per channel.
//
//     vec4 color = umbrage_to_unorm(channels);     // write: the same byte whether the store rounds or truncates
//     vec4 channels = umbrage_from_unorm(texel);   // read: integers, even if the driver divides by 255 inexactly
//
// `umbrage_to_unorm10` and `umbrage_to_unorm16`, and their inverses, do the same for 10 and 16 bits.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Bits per UNORM channel.
template <int Bits>
concept unorm_bits = Bits == 8 || Bits == 10 || Bits == 16;

/// Type of an integer channel in memory.
template <int Bits>
requires unorm_bits<Bits>
using unorm_channel = std::conditional_t<Bits == 8, std::uint8_t, std::uint16_t>;

/// Value to write so that a UNORM target stores channel k, whether it rounds or truncates.
///
/// @tparam Bits   bits per channel: 8, 10 or 16
/// @param k       channel, an integer from 0 to n = 2^Bits - 1
/// @return        about (k + 1/4) / n, with 10 bits down to (k + 1/150) / n; above 1 the store clamps
/// @edge          other values of k: values that a store clamps, or a NaN
/// @formula       8 bits: (257 k + 64) / 2^16
///                10 bits: (4099 k + 1056) / 2^22, because llvmpipe stores 16 bits and cuts off six of them
///                16 bits: min(k + floor(k / 256) / 256 + 1/4, 65536) / 65536
/// @exactness     A: at most 24 significant bits, or beyond the min
template <int Bits = 8, real T>
requires unorm_bits<Bits>
[[nodiscard]] constexpr T to_unorm(T k) {
    if constexpr (Bits == 16) {
        const T byte = k * T(1.0 / 256.0);
        const T above = T(byte > T(0) && byte < T(256) ? static_cast<int>(byte) : 0) * T(1.0 / 256.0) + T(0.25);
        const T wide = k + above;
        return (wide < T(65536) ? wide : T(65536)) * T(1.0 / 65536.0);
    } else if constexpr (Bits == 10) {
        return k * T(4099.0 / 4194304.0) + T(1056.0 / 4194304.0);
    } else {
        return k * T(257.0 / 65536.0) + T(64.0 / 65536.0);
    }
}
template <int Bits = 8, glm::length_t L, real T>
requires unorm_bits<Bits>
[[nodiscard]] constexpr glm::vec<L, T> to_unorm(glm::vec<L, T> k) {
    for (glm::length_t i = 0; i < L; ++i) k[i] = to_unorm<Bits>(k[i]);
    return k;
}

/// Channel k of a value read from a UNORM texture.
///
/// @tparam Bits   bits per channel: 8, 10 or 16
/// @param c       k / n with n = 2^Bits - 1. Its error may be thousands of ulp, or 60 ulp with 16 bits
/// @return        k, an integer from 0 to n
/// @edge          other values of c are not clamped
/// @formula       floor(n c + 1/2)
/// @exactness     A for values farther than 2^(Bits - 23) from the midpoint of two channels
template <int Bits = 8, real T>
requires unorm_bits<Bits>
[[nodiscard]] T from_unorm(T c) { return std::floor(c * T((1 << Bits) - 1) + T(0.5)); }
template <int Bits = 8, glm::length_t L, real T>
requires unorm_bits<Bits>
[[nodiscard]] glm::vec<L, T> from_unorm(glm::vec<L, T> c) {
    for (glm::length_t i = 0; i < L; ++i) c[i] = from_unorm<Bits>(c[i]);
    return c;
}

/// Rounding mode of a UNORM render target. It has no snippet, because in a shader the target itself stores.
enum class unorm_store { rounds, truncates };

/// Channel that a UNORM target stores.
/// @param c     any value, clamped to [0, 1]
/// @param mode  rounding of values between two channel steps
/// @edge        NaN: 0, as graphics APIs require
template <int Bits = 8, real T>
requires unorm_bits<Bits>
[[nodiscard]] constexpr unorm_channel<Bits> store_unorm(T c, unorm_store mode = unorm_store::rounds) {
    if (is_nan(c)) return 0;
    const T scaled = saturate(c) * T((1 << Bits) - 1);
    return static_cast<unorm_channel<Bits>>(mode == unorm_store::rounds ? scaled + T(0.5) : scaled);
}
template <int Bits = 8, glm::length_t L, real T>
requires unorm_bits<Bits>
[[nodiscard]] constexpr glm::vec<L, unorm_channel<Bits>> store_unorm(glm::vec<L, T> c,
                                                                     unorm_store mode = unorm_store::rounds) {
    glm::vec<L, unorm_channel<Bits>> channels(0);
    for (glm::length_t i = 0; i < L; ++i) channels[i] = store_unorm<Bits>(c[i], mode);
    return channels;
}

/// Values that sampling returns for stored channels: k / n.
template <int Bits = 8, real T = float, glm::length_t L>
requires unorm_bits<Bits>
[[nodiscard]] constexpr glm::vec<L, T> load_unorm(glm::vec<L, unorm_channel<Bits>> channels) {
    glm::vec<L, T> c(0);
    for (glm::length_t i = 0; i < L; ++i) c[i] = T(channels[i]) / T((1 << Bits) - 1);
    return c;
}

namespace glsl {
namespace detail {

/// A comment, then a function's text four times, with float, vec2, vec3 and vec4 for $t.
[[nodiscard]] inline std::string overloads(std::string_view comment, std::string_view function) {
    std::string text(comment);
    for (const std::string_view type : {"float", "vec2", "vec3", "vec4"}) append(text, function, {{'t', 0, type}});
    return text;
}

}  // namespace detail

inline constexpr snippet to_unorm{
    .name = "to_unorm",
    .summary = "value that makes an 8-bit target store channel 0..255",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_to_unorm(UMBRAGE_HIGHP $t k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
)GLSL");
        },
};

inline constexpr snippet from_unorm{
    .name = "from_unorm",
    .summary = "channel 0..255 of a value from an 8-bit texture",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_from_unorm(UMBRAGE_HIGHP $t c) {
    return floor(c * 255.0 + 0.5);
}
)GLSL");
        },
};

inline constexpr snippet to_unorm10{
    .name = "to_unorm10",
    .summary = "value that makes a 10-bit target store channel 0..1023",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_to_unorm10(UMBRAGE_HIGHP $t k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
)GLSL");
        },
};

inline constexpr snippet from_unorm10{
    .name = "from_unorm10",
    .summary = "channel 0..1023 of a value from a 10-bit texture",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_from_unorm10(UMBRAGE_HIGHP $t c) {
    return floor(c * 1023.0 + 0.5);
}
)GLSL");
        },
};

inline constexpr snippet to_unorm16{
    .name = "to_unorm16",
    .summary = "value that makes a 16-bit target store channel 0..65535",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_to_unorm16(UMBRAGE_HIGHP $t k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
)GLSL");
        },
};

inline constexpr snippet from_unorm16{
    .name = "from_unorm16",
    .summary = "channel 0..65535 of a value from a 16-bit texture",
    .exactness = tier::a,
    .source =
        +[] {
            return detail::overloads(R"GLSL(
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
)GLSL",
                                     R"GLSL(UMBRAGE_HIGHP $t umbrage_from_unorm16(UMBRAGE_HIGHP $t c) {
    return floor(c * 65535.0 + 0.5);
}
)GLSL");
        },
};

inline constexpr const snippet* unorm_snippets[]{&to_unorm,     &from_unorm, &to_unorm10,
                                                 &from_unorm10, &to_unorm16, &from_unorm16};

}  // namespace glsl
}  // namespace umbrage
