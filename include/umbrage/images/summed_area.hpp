// SPDX-License-Identifier: MIT
//
// Summed-area tables: the sum over any rectangle of an image from four texels.
//
//     umbrage::image<std::uint32_t> sums(values.size());
//     umbrage::summed_area(values, sums);
//     std::uint32_t sum = umbrage::box_sum(sums, {3, 5}, {10, 9});  // columns 3 .. 10, rows 5 .. 9
//
// Prefer integers: quantise depths or moments first. Their tables are exact, whatever the order; a table of floats
// loses bits as it grows, and its differences lose more.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/image.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

/// Floats are always added in fours, in the order that summed_area states; integers in any.
template <class T, isa Set>
inline constexpr int sum_lanes = std::is_integral_v<T>&& Set != isa::base ? running_sum_lanes : 4;

/// The running sums of a band, and those of the bands before it. A load waits for an earlier store whose address has
/// the same last twelve bits (4K aliasing): so both lie, modulo 4096, away from the rows of the image and of the table.
/// The worst placement was measured to be five times as slow.
template <class Sum>
class band_sums {
public:
    band_sums(std::size_t length, const void* from, const void* to) : memory_(2 * length + 2 * page / sizeof(Sum)) {
        const std::size_t a = last_bits(from), b = last_bits(to), ahead = (b - a) % page, behind = page - ahead;
        base = place(memory_.data(), ahead > behind ? a + ahead / 3 : b + behind / 3);
        line = place(base + length, ahead > behind ? a + 2 * ahead / 3 : b + 2 * behind / 3);
    }
    band_sums(const band_sums&) = delete;
    band_sums& operator=(const band_sums&) = delete;

private:
    static constexpr std::size_t page = 4096;
    static std::size_t last_bits(const void* p) { return reinterpret_cast<std::uintptr_t>(p) % page; }
    static Sum* place(Sum* from, std::size_t wanted) {
        return from + (wanted / 64 * 64 - last_bits(from)) % page / sizeof(Sum);
    }

    std::vector<Sum> memory_;

public:
    Sum *base, *line;
};

enum class table_store { none, plain, streaming };

/// Adds the running sums of a row of the image to `line`, and stores a row of the table: that plus `base`, or of
/// integers `line` itself, which then holds all that is above.
template <table_store Store, int Lanes, class From, class Sum>
UMBRAGE_INLINE inline void sum_row(const From* from, const Sum* base, Sum* line, Sum* to, int count) {
    using few = lanes_of<Sum, Lanes>;
    constexpr bool by_bytes = sums_bytes && sizeof(From) == 1 && Lanes == 8;
    constexpr int step = by_bytes ? 2 * Lanes : Lanes;
    few carry{};
    const auto add_few = [&](auto store, few& together, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        constexpr table_store how = decltype(store)::value;
        few sums, there;
        load_lanes(lines, there);
        sums = (carry + together) + there;
        all_last<Lanes>(together);
        carry = carry + together;
        store_lanes(sums, lines);
        if constexpr (how == table_store::none) return;
        if constexpr (!std::is_integral_v<Sum>) {
            load_lanes(under, there);
            sums = sums + there;
        }
        if constexpr (how == table_store::plain) store_lanes(sums, out);
        if constexpr (how == table_store::streaming) stream<sizeof sums>(out, &sums);
    };
    const auto sum_some = [&](auto store, const auto* values, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        few together;
        if constexpr (by_bytes) {
            few next;
            running_sums_of_bytes(values, together, next);
            add_few(store, together, under, lines, out);
            add_few(store, next, under + Lanes, lines + Lanes, out + Lanes);
        } else {
            load_lanes(values, together);
            running_sum<Lanes>(together);
            add_few(store, together, under, lines, out);
        }
    };
    constexpr std::integral_constant<table_store, Store> as_asked{};
    // Of the row's last few, which are copied from where they are put: not past the cache.
    constexpr std::integral_constant<table_store, Store == table_store::none ? Store : table_store::plain> to_copy{};
    if constexpr (Store == table_store::streaming) prefetch_rest(to, count, step);
    // Measured: the hardware prefetcher comes too late.
    const auto prefetch = [&](int first) UMBRAGE_INLINE {
        prefetch_bytes(from + first, 1536, block * static_cast<int>(sizeof(From)));
    };
    int x = 0;
    if constexpr (by_bytes) {
        for (; x + step <= count; x += step) {
            if (x % block == 0) prefetch(x);
            sum_some(as_asked, from + x, base + x, line + x, to + x);
        }
    } else {
        // This block and the next, which is loaded before the stores that its loads could alias with.
        alignas(64) Sum values[2][block];
        const auto load = [&](int first) UMBRAGE_INLINE {
            prefetch(first);
            for (int i = 0; i < block; ++i) values[first / block % 2][i] = from[first + i];
        };
        if (block <= count) load(0);
        for (; x + block <= count; x += block) {
            if (x + 2 * block <= count) load(x + block);
            const Sum* const now = values[x / block % 2];
            for (int i = 0; i < block; i += step) sum_some(as_asked, now + i, base + x + i, line + x + i, to + x + i);
        }
    }
    for (; x < count; x += step) {  // base and line are padded
        const int there = count - x < step ? count - x : step;
        std::conditional_t<by_bytes, From, Sum> rest[std::size_t(step)]{};
        alignas(Lanes * sizeof(Sum)) Sum result[std::size_t(step)];
        for (int i = 0; i < there; ++i) rest[i] = from[x + i];
        if (there == step) {
            sum_some(as_asked, rest, base + x, line + x, to + x);
        } else {
            sum_some(to_copy, rest, base + x, line + x, result);
            if constexpr (Store != table_store::none) std::copy_n(result, there, to + x);
        }
    }
}

inline constexpr int band_rows =
    64;  ///< rows of a table that are summed from zero, then put on top of what is before them

/// Rows first <= y < last of one band into the table; `line` becomes the sums of the band down to there.
template <class From, class Sum>
void sum_rows(image_view<const From> values, image_view<Sum> sums, int first, int last, const Sum* base, Sum* line) {
    const int width = sums.size.x;
    const bool is_large = past_cache(sums);
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr int lanes = sum_lanes<Sum, decltype(set)::value>;
        for (int y = first; y < last; ++y) {
            const From* from = values.row(y);
            Sum* to = sums.row(y);
            if (is_large && streams_to(to)) sum_row<table_store::streaming, lanes>(from, base, line, to, width);
            else sum_row<table_store::plain, lanes>(from, base, line, to, width);
        }
    });
    if (is_large) finish_streaming();
}

/// What those rows put under all that follow; `line` starts as zeros.
template <class From, class Sum>
void total_of_rows(image_view<const From> values, int first, int last, Sum* line) {
    const int width = values.size.x;
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        if constexpr (std::is_integral_v<Sum>) {  // in any order: down the columns, then along one row
            for (int y = first; y < last; ++y) {
                const From* from = values.row(y);
                int x = 0;
                for (; x + block <= width; x += block) {
                    UMBRAGE_NO_OVERLAP
                    for (int i = 0; i < block; ++i) line[x + i] += from[x + i];
                }
                for (; x < width; ++x) line[x] += from[x];
            }
            for (int x = 1; x < width; ++x) line[x] += line[x - 1];
        } else {
            for (int y = first; y < last; ++y)
                sum_row<table_store::none, sum_lanes<Sum, decltype(set)::value>>(values.row(y), line, line, line,
                                                                                 width);
        }
    });
}

}  // namespace detail

/// Each texel: the sum of all in its row and the rows before, up to and including its column.
///
/// @param values    uint8_t, uint16_t or uint32_t for a table of uint32_t; float for one of floats
/// @param sums      same size, other pixels
/// @param parallel  cuts bands of 64 rows into pieces, see parallel.hpp; the image is then read twice
/// @throws std::invalid_argument  sizes differ
/// @exactness   uint32_t A: modulo 2^32. float B. In a row, groups g of four from its start, each summed as g0, g0+g1,
///              (g1+g2)+g0, (g2+g3)+(g0+g1); to them the last sums of the groups before, added up from left to right;
///              to that the texel above, in bands of 64 rows; to that the last row of the bands before, added up
///              downwards
template <class From, class Sum, class ParallelFor = serial>
void summed_area(image_view<From> values, image_view<Sum> sums, ParallelFor&& parallel = {}) {
    using value = std::remove_const_t<From>;
    static_assert(std::is_same_v<Sum, float> ? std::is_same_v<value, float>
                                             : std::is_same_v<Sum, std::uint32_t> && std::is_unsigned_v<value> &&
                                                   sizeof(value) <= sizeof(Sum));
    if (values.size != sums.size) detail::fail("umbrage::summed_area: sizes differ");
    if (values.empty()) return;
    const int height = sums.size.y, bands = (height + detail::band_rows - 1) / detail::band_rows;
    const auto length = (static_cast<std::size_t>(sums.size.x) + 15) / 16 * 16;
    const auto end_of = [=](int b) { return b + 1 < bands ? (b + 1) * detail::band_rows : height; };
    const auto add = [=](const Sum* from, Sum* to) {
        for (std::size_t i = 0; i < length; ++i) to[i] = from[i] + to[i];
    };
    if constexpr (std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>) {
        detail::band_sums<Sum> band(length, values.data, sums.data);
        for (int b = 0; b < bands; ++b) {
            detail::sum_rows<value, Sum>(values, sums, b * detail::band_rows, end_of(b), band.base, band.line);
            if constexpr (std::is_integral_v<Sum>) continue;
            add(band.line, band.base);
            std::fill(band.line, band.line + length, Sum(0));
        }
    } else {
        // What each band puts under the next one, by itself and then with all before it; then the bands, in any order.
        std::vector<Sum> bases(length * static_cast<std::size_t>(bands));
        const auto base = [&](int b) { return bases.data() + length * static_cast<std::size_t>(b); };
        if (bands > 1)
            parallel(bands - 1, [&](int first, int last) {
                for (int b = first; b < last; ++b)
                    detail::total_of_rows<value, Sum>(values, b * detail::band_rows, end_of(b), base(b + 1));
            });
        for (int b = 1; b < bands; ++b) add(base(b - 1), base(b));
        parallel(bands, [&](int first, int last) {
            for (int b = first; b < last; ++b) {
                detail::band_sums<Sum> band(length, values.data, sums.data);
                std::copy(base(b), base(b) + length, std::is_integral_v<Sum> ? band.line : band.base);
                detail::sum_rows<value, Sum>(values, sums, b * detail::band_rows, end_of(b), band.base, band.line);
            }
        });
    }
}

/// The same where one of the two is an image.
template <class From, class Sums, class ParallelFor = serial>
requires detail::some_image<From, Sums>
void summed_area(const From& values, Sums&& sums, ParallelFor&& parallel = {}) {
    summed_area(detail::view_of(values), detail::view_of(sums), parallel);
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
template <class T>
[[nodiscard]] T box_sum(const image<T>& sums, glm::ivec2 first, glm::ivec2 last) {
    return box_sum(sums.view(), first, last);
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
