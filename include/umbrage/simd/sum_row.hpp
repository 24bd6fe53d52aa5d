// SPDX-License-Identifier: MIT
//
// Running sums along a row of an image, and down to a row of its summed-area table.
//
//     band_sums<Sum> band(length, values.data, sums.data);
//     Sum end = sum_row<streams, sum_lanes<Sum, Set>>(from, next_row, before, band.base, band.line, to, count);
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Number of lanes of a running sum. Floats are always added in fours, in the order that summed_area states; integers
/// in any order.
template <class T, isa Set>
inline constexpr int sum_lanes = std::is_integral_v<T>&& Set != isa::base ? running_sum_lanes : 4;

/// Running sums of a band, and those of the bands before it. A load waits for an earlier store whose address has the
/// same last twelve bits (4K aliasing). So both are placed, modulo 4096, away from the rows of the image and of the
/// table. The worst placement was measured to be five times as slow.
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

/// Adds the running sums of a row of the image to `line`, and stores a row of the table. The stored row is `line` plus
/// `base`. For integers it is `line` alone, which then includes all rows above.
/// @param before     sum of the row's texels to the left
/// @param next_row   row after `from`
/// @return           `before` plus the sum of all texels, in full blocks
template <bool Streams, int Lanes, class From, class Sum>
UMBRAGE_INLINE inline Sum sum_row(const From* from, const From* next_row, Sum before, const Sum* base, Sum* line,
                                  Sum* to, int count) {
    using few = lanes_of<Sum, Lanes>;
    constexpr bool by_bytes = sums_bytes && sizeof(From) == 1 && Lanes == 8;
    constexpr int step = by_bytes ? 2 * Lanes : Lanes;
    few carry{};
    for (int i = 0; i < Lanes; ++i) carry[i] = before;
    const auto add_few = [&](auto streams, few& together, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        few sums, there;
        load_lanes(lines, there);
        sums = (carry + together) + there;
        all_last<Lanes>(together);
        carry = carry + together;
        store_lanes(sums, lines);
        if constexpr (!std::is_integral_v<Sum>) {
            load_lanes(under, there);
            sums = sums + there;
        }
        if constexpr (decltype(streams)::value) stream<sizeof sums>(out, &sums);
        else store_lanes(sums, out);
    };
    const auto sum_some = [&](auto streams, const auto* values, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        few together;
        if constexpr (by_bytes) {
            few next;
            running_sums_of_bytes(values, together, next);
            add_few(streams, together, under, lines, out);
            add_few(streams, next, under + Lanes, lines + Lanes, out + Lanes);
        } else {
            load_lanes(values, together);
            running_sum<Lanes>(together);
            add_few(streams, together, under, lines, out);
        }
    };
    constexpr std::bool_constant<Streams> as_asked{};
    if constexpr (Streams) prefetch_rest(to, count, step);
    // Measured: the hardware prefetcher comes too late.
    const auto prefetch = [&](int first) UMBRAGE_INLINE {
        const int ahead = lesser(1536 / static_cast<int>(sizeof(From)), count), x = first + ahead;
        prefetch_bytes(x < count ? from + x : next_row + (x - count), 0, block * static_cast<int>(sizeof(From)));
    };
    int x = 0;
    if constexpr (by_bytes) {
        for (; x + step <= count; x += step) {
            if (x % block == 0) prefetch(x);
            sum_some(as_asked, from + x, base + x, line + x, to + x);
        }
    } else {
        // Values of this block and the next. The next is loaded before the stores with which its loads could alias.
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
            sum_some(std::false_type{}, rest, base + x, line + x, result);
            for (int i = 0; i < there; ++i) to[x + i] = result[i];
        }
    }
    return carry[0];
}

/// Result of sum_row alone, for full blocks.
template <int Lanes, class From, class Sum>
UMBRAGE_INLINE inline Sum sum_of_row(const From* from, Sum before, int count) {
    lanes_of<Sum, Lanes> carry, few;
    for (int i = 0; i < Lanes; ++i) carry[i] = std::is_integral_v<Sum> ? Sum(0) : before;
    for (int x = 0; x < count; x += block) {
        alignas(64) Sum values[block];
        for (int i = 0; i < block; ++i) values[i] = from[x + i];
        for (int i = 0; i < block; i += Lanes) {
            load_lanes(values + i, few);
            if constexpr (!std::is_integral_v<Sum>) running_sum<Lanes>(few), all_last<Lanes>(few);
            carry = carry + few;
        }
    }
    if constexpr (!std::is_integral_v<Sum>) return carry[0];
    running_sum<Lanes>(carry);
    return before + carry[Lanes - 1];
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
