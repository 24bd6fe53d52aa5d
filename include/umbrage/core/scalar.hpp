// SPDX-License-Identifier: MIT
//
// The scalar ground rules: which types are depths, what NaN means, what clamping does.
//
//     float d = umbrage::saturate(z);  // everything from 1 up, and NaN: 1;  everything from 0 down: 0
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

/// Scalars that primitives work on.
template <class T>
concept real = std::same_as<T, float> || std::same_as<T, double>;

/// Tests the bits, so that -ffast-math cannot remove it. The sign is shifted out: clang 22 removes a masked comparison.
[[nodiscard]] constexpr bool is_nan(float v) { return (detail::bit_cast<std::uint32_t>(v) << 1) > 0xFF000000u; }
[[nodiscard]] constexpr bool is_nan(double v) {
    return (detail::bit_cast<std::uint64_t>(v) << 1) > 0xFFE0000000000000ull;
}

/// True for everything but NaN and the infinities.
[[nodiscard]] constexpr bool is_finite(float v) { return (detail::bit_cast<std::uint32_t>(v) << 1) < 0xFF000000u; }
[[nodiscard]] constexpr bool is_finite(double v) {
    return (detail::bit_cast<std::uint64_t>(v) << 1) < 0xFFE0000000000000ull;
}

namespace detail {

/// Above all other numbers: where a search for the least starts. It stands for infinity, which -ffinite-math-only turns
/// into nonsense. In parentheses, as max may be a macro.
template <class T>
inline constexpr T highest = (std::numeric_limits<T>::max)();

/// Of a vector or a matrix: true when no element is NaN or infinite.
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

/// Clamps to [0, 1]. NaN of either sign becomes far, the cleared depth; -0 becomes +0.
/// @param cleared   1, or 0 where depth is reversed
/// @formula     v >= 1 ? 1 : (v > 0 ? v : (v <= 0 ? 0 : cleared))
/// @exactness   A: selects, never computes; by the order of the bits, so that -ffast-math leaves no -0 and no
///              flushing mode takes a denormal
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T saturate(T v, T cleared = T(1)) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    const auto own = detail::bit_cast<bits>(v), one = detail::bit_cast<bits>(T(1)), below = own < one ? own : one;
    return detail::bit_cast<T>(is_nan(v) ? detail::bit_cast<bits>(cleared) : (below > 0 ? below : 0));
}

namespace glsl {

inline constexpr snippet saturate{
    .name = "saturate",
    .summary = "clamp to [0, 1], NaN to far",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
)GLSL",
};

inline constexpr const snippet* scalar_snippets[]{&saturate};

}  // namespace glsl
}  // namespace umbrage
