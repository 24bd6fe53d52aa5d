// SPDX-License-Identifier: MIT
//
// Powers of two with the same bits on every machine, with which exponential shadow maps warp depth. No language
// guarantees that for its built-in exp2.
//
//     float warped = umbrage::exp2_polynomial(40.0f * depth);  // as fine as the float
//     float coarse = umbrage::exp2_steps(40.0f * depth);       // 12 bits, the same bits on every implementation
//
// Both are monotonic, and return exact powers of two at integers. The square of a coarse power is exact, from 2^-63 on.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include <glm/common.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Power of two with an integer exponent.
/// @param n       integer, -64 to 63
/// @return        2^n
/// @exactness     A
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T power_of_two(T n) {
    if constexpr (sizeof(T) == 4) return detail::bit_cast<T>((static_cast<std::int32_t>(n) + 127) << 23);
    else return detail::bit_cast<T>((static_cast<std::int64_t>(n) + 1023) << 52);
}

namespace detail {

/// c ? a : b on the bits. Compilers vectorize it where they do not vectorize the conditional.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T pick(bool c, T a, T b) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    const bits mask = -bits(c);
    return detail::bit_cast<T>((detail::bit_cast<bits>(a) & mask) | (detail::bit_cast<bits>(b) & ~mask));
}

/// Exponent clamped to [-64, 63]. NaN counts as -64.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T clamp_exponent(T y) {
    const T below = pick(y < T(63), y, T(63));
    return pick(bool(int(below > T(-64)) & int(!is_nan(y))), below, T(-64));
}

/// floor(v), for |v| < 2^31.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T floor_small(T v) {
    const auto toward_zero = static_cast<std::int32_t>(v);
    return static_cast<T>(toward_zero - std::int32_t(static_cast<T>(toward_zero) > v));
}

}  // namespace detail

/// Power of two, as fine as the float.
/// @param y       exponent; clamped to [-64, 63], NaN is -64
/// @return        2^y: monotonic, exact at integers
/// @formula       2^n (1 + c1 f + c2 f^2 + .. + c5 f^5) by Horner's scheme, n = floor(y), f = y - n. The polynomial is
///                2 at f = 1
/// @exactness     B, n = 16, S = 2^n (1 + c1 g + .. + c5 g^5), g = |y| + |n|;  off by at most 1.8e-7 of the power, over
///                all f = k / 2^24
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T exp2_polynomial(T y) {
    const T x = detail::clamp_exponent(y), n = detail::floor_small(x), f = x - n;
    T p = T(16143224 * 0x1p-33) * f + T(9654007 * 0x1p-30);
    p = p * f + T(14983712 * 0x1p-28);
    p = p * f + T(16116816 * 0x1p-26);
    p = p * f + T(11629156 * 0x1p-24);
    p = p * f + T(1);
    return p * power_of_two(n);
}

/// Power of two in steps of 12 bits.
/// @param y       exponent; clamped to [-64, 63], NaN is -64
/// @return        2^y in steps: an integer below 2^12 times a power of two. It is monotonic, and exact for integers
/// @formula       m 2^(n - 11), x = floor(2048 y), n = floor(x / 2048), f = x - 2048 n, g = floor(f (2048 - f) / 256),
///                r = 1251 + floor(314 f / 2048), m = 2048 + f - floor((g r + 2^14) / 2^15)
/// @exactness     A;  off by at most 3.1e-4 of the power at the steps, over all of them. Between two steps it keeps the
///                lower value
template <real T>
[[nodiscard]] T exp2_steps(T y) {
    const T x = std::floor(detail::clamp_exponent(y) * T(2048));
    const T n = std::floor(x * T(0x1p-11)),
            f = (glm::max)(x - n * T(2048), T(0));  // no sum is regrouped across the maximum
    const T g = std::floor(f * (T(2048) - f) * T(0x1p-8)), r = T(1251) + std::floor(f * T(314) * T(0x1p-11));
    const T m = T(2048) + f - std::floor((g * r + T(16384)) * T(0x1p-15));
    return m * T(0x1p-11) * power_of_two(n);
}

namespace glsl {

inline constexpr snippet power_of_two{
    .name = "power_of_two",
    .summary = "2^n of integers n from -64 to 63",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
UMBRAGE_HIGHP float umbrage_power_of_two(UMBRAGE_HIGHP float n) {
#if __VERSION__ >= 300
    UMBRAGE_HIGHP uint exponent = uint(n + 127.0);
    return uintBitsToFloat(exponent << 23);
#else
    UMBRAGE_HIGHP float x = n < 0.0 ? n + 64.0 : n;
    UMBRAGE_HIGHP float p = 1.0;
    p = n < 0.0 ? p * (1.0 / 4294967296.0) * (1.0 / 4294967296.0) : p;
    p = x >= 32.0 ? p * 4294967296.0 : p;
    x = x >= 32.0 ? x - 32.0 : x;
    p = x >= 16.0 ? p * 65536.0 : p;
    x = x >= 16.0 ? x - 16.0 : x;
    p = x >= 8.0 ? p * 256.0 : p;
    x = x >= 8.0 ? x - 8.0 : x;
    p = x >= 4.0 ? p * 16.0 : p;
    x = x >= 4.0 ? x - 4.0 : x;
    p = x >= 2.0 ? p * 4.0 : p;
    x = x >= 2.0 ? x - 2.0 : x;
    return x >= 1.0 ? p * 2.0 : p;
#endif
}
)GLSL",
};

inline constexpr snippet exp2_polynomial{
    .name = "exp2_polynomial",
    .summary = "2^y, off by at most 1.8e-7 of itself",
    .exactness = tier::b,
    .operations = 16,
    .needs = list<&power_of_two>,
    .source = R"GLSL(
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
UMBRAGE_HIGHP float umbrage_exp2_polynomial(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = y > -64.0 ? min(y, 63.0) : -64.0;
    UMBRAGE_HIGHP float n = floor(x);
    UMBRAGE_HIGHP float f = x - n;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
)GLSL",
};

inline constexpr snippet exp2_steps{
    .name = "exp2_steps",
    .summary = "2^y in steps of 12 bits",
    .exactness = tier::a,
    .needs = list<&power_of_two>,
    .source = R"GLSL(
// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
UMBRAGE_HIGHP float umbrage_exp2_steps(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    UMBRAGE_HIGHP float n = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    UMBRAGE_HIGHP float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    UMBRAGE_HIGHP float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
)GLSL",
};

inline constexpr const snippet* exp2_snippets[]{&power_of_two, &exp2_polynomial, &exp2_steps};

}  // namespace glsl
}  // namespace umbrage
