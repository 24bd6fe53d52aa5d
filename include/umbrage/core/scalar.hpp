// SPDX-License-Identifier: MIT
//
// Rules for scalars: the types of depth, the meaning of NaN, and the clamp to [0, 1].
//
//     float d = umbrage::saturate(z);  // 1 for 1 and above and for NaN, 0 for 0 and below
//
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Scalar types of the primitives.
template <class T>
concept real = std::same_as<T, float> || std::same_as<T, double>;

/// True for NaN. Tests the bits, since -ffast-math removes comparisons with NaN. The shift drops the sign: clang 22
/// removes a masked comparison.
[[nodiscard]] constexpr bool is_nan(float v) { return (detail::bit_cast<std::uint32_t>(v) << 1) > 0xFF000000u; }
[[nodiscard]] constexpr bool is_nan(double v) {
    return (detail::bit_cast<std::uint64_t>(v) << 1) > 0xFFE0000000000000ull;
}

/// True for all values except NaN and the infinities.
[[nodiscard]] constexpr bool is_finite(float v) { return (detail::bit_cast<std::uint32_t>(v) << 1) < 0xFF000000u; }
[[nodiscard]] constexpr bool is_finite(double v) {
    return (detail::bit_cast<std::uint64_t>(v) << 1) < 0xFFE0000000000000ull;
}

namespace detail {

/// Largest number, where a search for a minimum starts. It replaces infinity, which -ffinite-math-only makes undefined.
/// The parentheses protect it from a macro max.
template <class T>
inline constexpr T highest = (std::numeric_limits<T>::max)();

/// True if no element of a vector or a matrix is NaN or infinite.
template <class Elements>
[[nodiscard]] constexpr bool all_finite(const Elements& v) {
    for (decltype(v.length()) i = 0; i < v.length(); ++i) {
        if constexpr (requires { is_finite(v[i]); }) {
            if (!is_finite(v[i])) return false;
        } else if (!all_finite(v[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace detail

/// Clamps to [0, 1].
/// @param v         any value, NaN included
/// @param cleared   depth of the far plane: 1, or 0 for reversed depth
/// @edge        NaN of either sign: cleared. -0: +0
/// @formula     v >= 1 ? 1 : (v > 0 ? v : (v <= 0 ? 0 : cleared))
/// @exactness   A: it selects by the bits and computes nothing. So -ffast-math leaves no -0, and a mode that flushes
///              denormals changes none
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T saturate(T v, T cleared = T(1)) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    const auto own = detail::bit_cast<bits>(v), one = detail::bit_cast<bits>(T(1)), below = own < one ? own : one;
    return detail::bit_cast<T>(is_nan(v) ? detail::bit_cast<bits>(cleared) : (below > 0 ? below : 0));
}

namespace glsl {

inline constexpr snippet saturate{
    .name = "saturate",
    .summary = "clamp to [0, 1]; NaN becomes the far plane",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
)GLSL",
};

inline constexpr const snippet* scalar_snippets[]{&saturate};

}  // namespace glsl
}  // namespace umbrage
