// SPDX-License-Identifier: MIT
//
// What the library needs of <algorithm>. To include that takes a quarter as long as all else that programs with shadow
// maps include of the standard library and of GLM.
//
//     detail::sort(points, [](glm::vec2 a, glm::vec2 b) { return a.x < b.x; });
//
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <umbrage/core/config.hpp>

namespace umbrage::detail {

/// std::min, std::max and std::clamp, by value, by names that no platform's header defines as macros.
template <class T>
[[nodiscard]] UMBRAGE_INLINE constexpr T lesser(T a, T b) {
    return b < a ? b : a;
}
template <class T>
[[nodiscard]] UMBRAGE_INLINE constexpr T greater(T a, T b) {
    return a < b ? b : a;
}

/// Of vectors, element by element.
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

/// std::copy_n and std::fill_n.
template <class T>
UMBRAGE_INLINE constexpr void copy(const T* from, std::size_t count, T* to) {
    for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
}
template <class T>
UMBRAGE_INLINE constexpr void fill(T* to, std::size_t count, const T& value) {
    for (std::size_t i = 0; i < count; ++i) to[i] = value;
}

/// Merges runs twice as long in each turn; what is equal stays in its order.
/// @param before   (const T&, const T&)
template <class T, class Before>
void sort(std::vector<T>& all, const Before& before) {
    for (std::size_t run = 1; run < all.size(); run *= 2) {
        const std::vector<T> from = all;
        for (std::size_t to = 0; to < all.size();) {
            std::size_t a = to, b = lesser(to + run, all.size());
            const std::size_t end_a = b, end_b = lesser(b + run, all.size());
            while (to < end_b)
                all[to++] = a < end_a && !(b < end_b && before(from[b], from[a])) ? from[a++] : from[b++];
        }
    }
}

/// How many elements, from the first on, are `in_front`, as those behind them are not.
template <class T, class InFront>
[[nodiscard]] std::size_t count_in_front(const std::vector<T>& sorted, const InFront& in_front) {
    std::size_t first = 0;
    for (std::size_t last = sorted.size(); first < last;) {
        const std::size_t middle = first + (last - first) / 2;
        if (in_front(sorted[middle])) first = middle + 1;
        else last = middle;
    }
    return first;
}

/// The element that would be all[rank], were all sorted; changes their order. None may be a NaN.
/// @cite   Hoare: Algorithm 65: find, 1961
template <class T>
[[nodiscard]] T ranked(std::vector<T>& all, std::size_t rank) {
    for (std::size_t first = 0, last = all.size() - 1; first < last;) {
        const T pivot = all[rank];
        std::size_t i = first, end = last + 1;
        while (i < end) {
            while (all[i] < pivot) ++i;
            while (pivot < all[end - 1]) --end;
            if (i >= end) break;
            std::swap(all[i++], all[--end]);
        }
        if (rank < end) last = end - 1;
        else if (rank >= i) first = i;
        else break;
    }
    return all[rank];
}

}  // namespace umbrage::detail
