// SPDX-License-Identifier: MIT
//
// std::min, std::max and std::clamp by value, for scalars and for vectors element by element.
// No platform header defines these names as macros.
//
//     detail::lesser(glm::vec2(1, 4), glm::vec2(2, 3));  // (1, 3)
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

template <class V>
concept has_elements = requires {
    V::length();
};
template <has_elements V>
[[nodiscard]] UMBRAGE_INLINE constexpr V lesser(V a, V b) {
    for (decltype(V::length()) i = 0; i < V::length(); ++i) a[i] = lesser(a[i], b[i]);
    return a;
}
template <has_elements V>
[[nodiscard]] UMBRAGE_INLINE constexpr V greater(V a, V b) {
    for (decltype(V::length()) i = 0; i < V::length(); ++i) a[i] = greater(a[i], b[i]);
    return a;
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
