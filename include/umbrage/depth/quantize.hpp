// SPDX-License-Identifier: MIT
//
// Quantized depth: a depth as an integer of Bits bits (its code), and back. All encodings of this library build on it.
//
//     std::uint32_t x = umbrage::to_code<11>(0.5f);                         // 1024
//     float d = umbrage::from_code<11>(float(x), umbrage::upper_edge<float>);  // 1025 / 2048
//
#pragma once

#include <cstdint>

#include <umbrage/core/scalar.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Lower end of a quantization step [x, x + 1) 2^-Bits, as the depth to which a code x decodes.
template <real T>
inline constexpr T lower_edge = T(0);

/// Center of a quantization step, as the depth to which its code decodes.
template <real T>
inline constexpr T center = T(0.5);

/// Upper end of a quantization step, as the depth to which its code decodes. No surface shadows itself by quantization
/// alone: d <= decode(encode(d)) for every d in [0, 1]. The cleared depth 1 decodes to 1.
template <real T>
inline constexpr T upper_edge = T(1);

/// Code of a depth.
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          0 .. 2^Bits - 1
/// @edge            NaN: the code of the cleared depth
/// @formula         min(floor(depth 2^Bits), 2^Bits - 1)
/// @exactness       A: scaling by a power of two, floor, min
template <int Bits, real T>
[[nodiscard]] constexpr std::uint32_t to_code(T depth, T cleared = T(1)) {
    static_assert(Bits >= 1 && Bits <= 24, "a binary32 significand has 24 bits");
    constexpr std::uint32_t codes = std::uint32_t(1) << Bits;
    const auto x = static_cast<std::uint32_t>(saturate(depth, cleared) * T(codes));
    return x < codes ? x : codes - 1;
}

/// Depth of a code.
/// @param code    0 .. 2^Bits - 1
/// @param edge    lower_edge, center or upper_edge
/// @return        (code + edge) 2^-Bits
/// @exactness     A, except for the center of 24 bits in binary32, which needs a 25th bit from code 2^23 on (then B)
template <int Bits, real T>
[[nodiscard]] constexpr T from_code(T code, T edge) {
    return (code + edge) * (T(1) / T(std::uint32_t(1) << Bits));
}

/// Largest errors of from_code(to_code(depth)), below and above the depth.
[[nodiscard]] constexpr decoding_error edge_error(int bits, float edge) {
    const double step = 1.0 / static_cast<double>(std::uint32_t(1) << bits);
    return {.below = (1.0 - static_cast<double>(edge)) * step, .above = static_cast<double>(edge) * step};
}

}  // namespace umbrage
