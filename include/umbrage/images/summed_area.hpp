// SPDX-License-Identifier: MIT
//
// Summed-area table (SAT, integral image): the sum over any rectangle of an image from four texels.
//
//     umbrage::image<std::uint32_t> sums(values.size());
//     umbrage::summed_area(values, sums);
//     std::uint32_t sum = umbrage::box_sum(sums, {3, 5}, {10, 9});  // columns 3 .. 10, rows 5 .. 9
//
// Prefer integers: quantize depths or moments first. Their tables are exact in any order. A table of floats loses bits
// as it grows, and its differences lose more.
// Also called: SAT, integral image (summed_area).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>
#include <umbrage/simd/sum_row.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

/// Rows of a table that are summed from zero. They are then added to the sums before them.
inline constexpr int band_rows = 64;

/// Columns of the strips that threads take: full blocks of equal width. There are two strips or more if there are two
/// blocks. Each row of a strip is on its own memory page, so narrow strips are slower.
[[nodiscard]] inline int columns_a_strip(int width) {
    constexpr int widest = 1024;
    const int strips = greater(2, (width + widest - 1) / widest);
    return ((width + strips - 1) / strips + block - 1) / block * block;
}

/// Rows of a strip, in one band. `line` holds the sums of the rows above them in the band, then those up to the last
/// row.
/// @param before   per row, the sum of all texels to the left of the strip, then the sum up to its end
template <class From, class Sum>
void sum_rows(image_view<const From> values, image_view<Sum> sums, bool is_large, Sum* before, const Sum* base,
              Sum* line) {
    const glm::ivec2 size = sums.size;
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr int lanes = sum_lanes<Sum, decltype(set)::value>;
        for (int y = 0; y < size.y; ++y) {
            const int y_next = lesser(y + 1, size.y - 1);
            const From *from = values.row(y), *next_row = values.row(y_next);
            Sum* to = sums.row(y);
            prefetch_line(sums.row(y_next));  // for the address of its page, which stores would wait for
            if (is_large && streams_to(to))
                before[y] = sum_row<true, lanes>(from, next_row, before[y], base, line, to, size.x);
            else before[y] = sum_row<false, lanes>(from, next_row, before[y], base, line, to, size.x);
        }
    });
    if (is_large) finish_streaming();
}

/// Sums of each row up to where strips begin. The thread that has summed a strip passes them to the next one. Pieces
/// run when and where a scheduler likes, so none may wait for another. A thread adds up missing sums again.
template <class From, class Sum>
class strip_starts {
public:
    strip_starts(image_view<const From> values, int strips, int columns)
        : values_(values),
          columns_(columns),
          sums_(static_cast<std::size_t>(strips + 1) * static_cast<std::size_t>(values.size.y)),
          rows_(static_cast<std::size_t>(strips + 1)) {
        rows_[0] = values.size.y;
    }

    /// Sums of rows first <= y < last.
    void take(int strip, int first, int last, Sum* sums) const {
        int known = strip;
        while (load_acquire(rows_[std::size_t(known)]) < last) --known;
        std::copy_n(sums_.data() + place_of(known, first), last - first, sums);
        const int left = known * columns_, width = strip * columns_ - left;
        on_best_isa([&](auto set) UMBRAGE_INLINE {
            constexpr int lanes = sum_lanes<Sum, decltype(set)::value>;
            for (int y = first; y < last; ++y, ++sums) *sums = sum_of_row<lanes>(values_.row(y) + left, *sums, width);
        });
    }
    /// Stores the sums of rows first <= y < last, after those of the rows before.
    void give(int strip, int first, int last, const Sum* sums) {
        std::copy_n(sums, last - first, sums_.data() + place_of(strip, first));
        store_release(last, rows_[std::size_t(strip)]);
    }

private:
    [[nodiscard]] std::size_t place_of(int strip, int y) const {
        return static_cast<std::size_t>(strip) * static_cast<std::size_t>(values_.size.y) + static_cast<std::size_t>(y);
    }

    image_view<const From> values_;
    int columns_;
    std::vector<Sum> sums_;  // one strip after another, and one sum after the last
    std::vector<int> rows_;  // number of rows whose sums are there, set by one thread while others read it
};

}  // namespace detail

/// Summed-area table: each texel is the sum of all texels in its row and the rows before, up to and including its
/// column.
///
/// @param values    uint8_t, uint16_t or uint32_t for a table of uint32_t; float for one of floats
/// @param sums      same size, other pixels
/// @param parallel  cuts strips of up to 1024 columns into pieces, see parallel.hpp. Strips should run in order, or at
///                  the same time. Other orders read some of the image twice or more
/// @throws std::invalid_argument  sizes differ
/// @exactness   uint32_t A: modulo 2^32. float B. In a row, groups g of four from its start, each summed as g0, g0+g1,
///              (g1+g2)+g0, (g2+g3)+(g0+g1). Added to them are the last sums of the groups before, summed from left to
///              right; then the texel above, in bands of 64 rows; then the last row of the bands before, summed
///              downwards
template <class From, class Sum, class ParallelFor = serial>
void summed_area(image_view<From> values, image_view<Sum> sums, ParallelFor&& parallel = {}) {
    using value = std::remove_const_t<From>;
    static_assert(std::is_same_v<Sum, float> ? std::is_same_v<value, float>
                                             : std::is_same_v<Sum, std::uint32_t> && std::is_unsigned_v<value> &&
                                                   sizeof(value) <= sizeof(Sum));
    detail::require_size(sums.size, values.size, "summed_area", "sums.size", "the values' size");
    if (values.empty()) return;
    constexpr bool in_one = std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>;
    const glm::ivec2 size = sums.size;
    const int columns = in_one ? size.x : detail::columns_a_strip(size.x), strips = (size.x + columns - 1) / columns;
    const bool is_large = detail::past_cache(sums);
    detail::strip_starts<value, Sum> starts(values, strips, columns);
    parallel(strips, [&](int first, int last) {
        if (first == last) return;
        const int left = first * columns, width = detail::lesser(last * columns, size.x) - left;
        const auto length = (static_cast<std::size_t>(width) + 15) / 16 * 16;
        detail::band_sums<Sum> band(length, values.data + left, sums.data + left);
        for (int y = 0; y < size.y; y += detail::band_rows) {
            const int end = detail::lesser(y + detail::band_rows, size.y);
            const auto part = [=](const auto& image) { return image.region({left, y}, {width, end - y}); };
            Sum before[detail::band_rows];
            starts.take(first, y, end, before);
            detail::sum_rows<value, Sum>(part(values), part(sums), is_large, before, band.base, band.line);
            starts.give(last, y, end, before);
            if constexpr (std::is_integral_v<Sum>) continue;
            for (std::size_t i = 0; i < length; ++i) band.base[i] = band.line[i] + band.base[i];
            std::fill_n(band.line, length, Sum(0));
        }
    });
}

/// Summed-area table for arguments of which one or both are an image.
template <class From, class Sums, class ParallelFor = serial>
requires detail::some_image<From, Sums>
void summed_area(const From& values, Sums&& sums, ParallelFor&& parallel = {}) {
    summed_area(detail::view_of(values), detail::view_of(sums), parallel);
}

/// Sum over a rectangle of the image from which a table was made.
///
/// @param sums     a table from summed_area
/// @param first    lowest column and row
/// @param last     highest column and row, included
/// @edge           texels outside the image count as 0, as does a rectangle with last < first
/// @formula        S(last) - S(first.x - 1, last.y) - S(last.x, first.y - 1) + S(first - 1)
/// @exactness      uint32_t A: exact while the rectangle's area times the largest value < 2^32, even where sums of the
///                 table have wrapped around. float B
template <class T>
[[nodiscard]] std::remove_const_t<T> box_sum(image_view<T> sums, glm::ivec2 first, glm::ivec2 last) {
    const int left = first.x > 0 ? first.x : 0, right = last.x < sums.size.x ? last.x : sums.size.x - 1;
    const int low = first.y > 0 ? first.y : 0, high = last.y < sums.size.y ? last.y : sums.size.y - 1;
    if (left > right || low > high) return 0;
    const auto at = [&](int x, int y) { return x < 0 || y < 0 ? std::remove_const_t<T>(0) : sums.row(y)[x]; };
    return ((at(right, high) - at(left - 1, high)) - at(right, low - 1)) + at(left - 1, low - 1);
}
template <class T>
[[nodiscard]] T box_sum(const image<T>& sums, glm::ivec2 first, glm::ivec2 last) {
    return box_sum(sums.view(), first, last);
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
