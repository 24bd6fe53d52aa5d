// SPDX-License-Identifier: MIT
//
// Summed-area tables: the sum over any rectangle of an image from four texels.
//
//     umbrage::image<std::uint32_t> sums(values.size());
//     umbrage::summed_area(values.view(), sums.view());
//     std::uint32_t sum = umbrage::box_sum(sums.view(), {3, 5}, {10, 9});  // columns 3 .. 10, rows 5 .. 9
//
// Prefer integers: quantise depths or moments first. Their tables are exact, whatever the order; a table of floats
// loses bits as it grows, and its differences lose more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

#include <glm/vec2.hpp>

#include <umbrage/image.hpp>
#include <umbrage/image_ops/isa.hpp>
#include <umbrage/image_ops/parallel.hpp>

namespace umbrage {
namespace detail {

/// Four neighbours in a row, and the steps of a running sum over them.
template <class T>
struct quad {
#if defined(__GNUC__) || defined(__clang__)
    typedef T lanes __attribute__((vector_size(4 * sizeof(T))));
#else
    struct lanes {
        T at[4];
        T& operator[](int i) { return at[i]; }
        friend lanes operator+(lanes a, lanes b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}; }
    };
#endif
    static UMBRAGE_INLINE lanes load(const T* from) {
        lanes v;
        std::memcpy(&v, from, sizeof v);
        return v;
    }
    template <class From>
    static UMBRAGE_INLINE lanes load(const From* from) {
        return lanes{static_cast<T>(from[0]), static_cast<T>(from[1]), static_cast<T>(from[2]), static_cast<T>(from[3])};
    }
    static UMBRAGE_INLINE void store(lanes v, T* to) { std::memcpy(to, &v, sizeof v); }

    /// Each plus those before it.
    static UMBRAGE_INLINE lanes running_sum(lanes v) {
        v = v + lanes{T(0), v[0], v[1], v[2]};
        return v + lanes{T(0), T(0), v[0], v[1]};
    }
    static UMBRAGE_INLINE lanes all_last(lanes v) { return lanes{v[3], v[3], v[3], v[3]}; }
};

/// One row of a table; `above` is the row before it, or null.
template <bool Add, class From, class Sum>
UMBRAGE_INLINE inline void sum_row(const From* from, const Sum* above, Sum* to, int count) {
    using four = quad<Sum>;
    typename four::lanes carry{};
    const auto step = [&](const From* values, const Sum* on_top, Sum* result) UMBRAGE_INLINE {
        const auto group = four::running_sum(four::load(values)), sums = carry + group;
        carry = carry + four::all_last(group);
        if constexpr (Add)
            four::store(sums + four::load(on_top), result);
        else
            four::store(sums, result);
    };
    int x = 0;
    for (; x + 4 <= count; x += 4) step(from + x, Add ? above + x : nullptr, to + x);
    if (x == count) return;
    From values[4]{};
    Sum on_top[4]{}, result[4];
    for (int i = 0; i < count - x; ++i) {
        values[i] = from[x + i];
        if constexpr (Add) on_top[i] = above[x + i];
    }
    step(values, on_top, result);
    for (int i = 0; i < count - x; ++i) to[x + i] = result[i];
}

}  // namespace detail

/// Each texel: the sum of all in its row and the rows before, up to and including its column.
///
/// @param values    uint8_t, uint16_t or uint32_t for a table of uint32_t; float for one of floats
/// @param sums      same size, other pixels
/// @param parallel  cuts rows, then columns, into pieces, see parallel.hpp; pieces cost a second pass over the table
/// @throws std::invalid_argument  sizes differ
/// @exactness   uint32_t A: modulo 2^32. float B: in a row, groups g of four from its start, each summed as
///              g0, g0+g1, (g1+g2)+g0, (g2+g3)+(g0+g1); to them the last sums of the groups before, added up from left to
///              right; to that the texel above
template <class From, class Sum, class ParallelFor = serial>
void summed_area(image_view<From> values, image_view<Sum> sums, ParallelFor&& parallel = {}) {
    using value = std::remove_const_t<From>;
    static_assert(std::is_same_v<Sum, float> ? std::is_same_v<value, float>
                                             : std::is_same_v<Sum, std::uint32_t> && std::is_unsigned_v<value> &&
                                                   sizeof(value) <= sizeof(Sum));
    if (values.size != sums.size) throw std::invalid_argument("umbrage::summed_area: sizes differ");
    if (values.empty()) return;
    if constexpr (std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            detail::sum_row<false>(static_cast<const value*>(values.row(0)), static_cast<const Sum*>(nullptr), sums.row(0), sums.size.x);
            for (int y = 1; y < sums.size.y; ++y)
                detail::sum_row<true>(static_cast<const value*>(values.row(y)), static_cast<const Sum*>(sums.row(y - 1)),
                                      sums.row(y), sums.size.x);
        });
    } else {
        parallel(sums.size.y, [&](int first, int last) {
            detail::on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = first; y < last; ++y)
                    detail::sum_row<false>(static_cast<const value*>(values.row(y)), static_cast<const Sum*>(nullptr),
                                           sums.row(y), sums.size.x);
            });
        });
        constexpr int columns = 16;  // a cache line: no two pieces share one
        parallel((sums.size.x + columns - 1) / columns, [&](int first, int last) {
            const int begin = first * columns, end = last * columns < sums.size.x ? last * columns : sums.size.x;
            detail::on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = 1; y < sums.size.y; ++y) {
                    const Sum* above = sums.row(y - 1);
                    Sum* row = sums.row(y);
                    int x = begin;
                    for (; x + columns <= end; x += columns) {
                        Sum total[columns];
                        for (int i = 0; i < columns; ++i) total[i] = row[x + i] + above[x + i];
                        std::memcpy(row + x, total, sizeof total);
                    }
                    for (; x < end; ++x) row[x] = row[x] + above[x];
                }
            });
        });
    }
}

/// Sum over a rectangle of the image that a table was made of.
///
/// @param sums     a table from summed_area
/// @param first    lowest column and row
/// @param last     highest column and row, they count too
/// @return         what lies outside the image counts as 0, as does a rectangle with last < first
/// @formula        S(last) - S(first.x - 1, last.y) - S(last.x, first.y - 1) + S(first - 1)
/// @exactness      uint32_t A: exact while the rectangle's area times the greatest value < 2^32, even where sums of the
///                 table have wrapped around. float B
template <class T>
[[nodiscard]] std::remove_const_t<T> box_sum(image_view<T> sums, glm::ivec2 first, glm::ivec2 last) {
    const int left = first.x > 0 ? first.x : 0, right = last.x < sums.size.x ? last.x : sums.size.x - 1;
    const int low = first.y > 0 ? first.y : 0, high = last.y < sums.size.y ? last.y : sums.size.y - 1;
    if (left > right || low > high) return 0;
    const auto at = [&](int x, int y) { return x < 0 || y < 0 ? std::remove_const_t<T>(0) : sums.row(y)[x]; };
    return ((at(right, high) - at(left - 1, high)) - at(right, low - 1)) + at(left - 1, low - 1);
}

}  // namespace umbrage
