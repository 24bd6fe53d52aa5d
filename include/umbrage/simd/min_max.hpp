// SPDX-License-Identifier: MIT
//
// Minimum, maximum and clamp of scalars by value, always inline: loops that call them become vectors on every path.
// No platform header defines these names as macros. Elsewhere there are GLM's.
//
//     detail::lesser(3, 1, 2);  // 1
//
#pragma once

#include <umbrage/core/config.hpp>

namespace umbrage::detail {

template <class T>
[[nodiscard]] UMBRAGE_INLINE constexpr T lesser(T a, T b) {
    return b < a ? b : a;
}
template <class T>
[[nodiscard]] UMBRAGE_INLINE constexpr T greater(T a, T b) {
    return a < b ? b : a;
}

template <class T, class... More>
[[nodiscard]] UMBRAGE_INLINE constexpr T lesser(T a, T b, More... more) {
    return lesser(lesser(a, b), more...);
}
template <class T, class... More>
[[nodiscard]] UMBRAGE_INLINE constexpr T greater(T a, T b, More... more) {
    return greater(greater(a, b), more...);
}
template <class T>
[[nodiscard]] UMBRAGE_INLINE constexpr T limited(T v, T low, T high) {
    return v < low ? low : (high < v ? high : v);
}

}  // namespace umbrage::detail
