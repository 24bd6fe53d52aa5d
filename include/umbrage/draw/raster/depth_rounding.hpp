// SPDX-License-Identifier: MIT
//
// Rounding of depths side by side to the nearest float: two registers of doubles to one of floats.
//
//     const depths_of_binade<8> depths(lowest);
//     depths.count(first, second);  // texels 0 .. 7, in the lanes in which it takes their depths
//     depths.round(first, second, floats);
//
#pragma once

#include <bit>
#include <cstdint>
#include <utility>

#include <umbrage/core/config.hpp>
#include <umbrage/draw/raster/triangles.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/lanes.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Rounding of any depths, limited to a triangle's. Floats above 0 have the order of their bits.
template <int Lanes>
class any_depths {
public:
    using ints = lanes_of<std::int32_t, Lanes>;
    using floats = lanes_of<float, Lanes>;
    using doubles = lanes_of<double, Lanes / 2>;

    /// @param lowest          normal number above 0
    /// @param highest         normal number above 0
    UMBRAGE_INLINE any_depths(double lowest, double highest)
        : lowest_(bit_cast<std::int32_t>(static_cast<float>(lowest)) + ints{}),
          highest_(bit_cast<std::int32_t>(static_cast<float>(highest)) + ints{}) {}

    UMBRAGE_INLINE static void count(doubles& first, doubles& second) {
        count_lanes<double, Lanes / 2>(first);
        second = first + double(Lanes / 2);
    }
    UMBRAGE_INLINE void round(const doubles& first, const doubles& second, floats& depths) const {
        narrow_lanes<float, Lanes>(first, second, depths);
        ints bits = reinterpret_cast<ints>(depths);
        keep_greatest(lowest_, bits);
        keep_least(highest_, bits);
        depths = reinterpret_cast<floats>(bits);
    }

private:
    ints lowest_, highest_;
};

/// Rounding of depths between a power of two and the next, where floats are one step apart.
///
/// A sum with a large number is rounded to that step. The number is such that the sum's lower half then is the float.
/// Conversion of doubles takes processors several times as long. Results of other depths are undefined.
template <int Lanes>
class depths_of_binade {
public:
    using floats = lanes_of<float, Lanes>;
    using doubles = lanes_of<double, Lanes / 2>;

    /// @param one   one of the depths
    UMBRAGE_INLINE explicit depths_of_binade(double one) {
        const std::int32_t power = bit_cast<std::int32_t>(static_cast<float>(one)) & 0x7F800000, steps = 1 << 23;
        large_ = (0x1.8p52 + (power - steps)) * (static_cast<double>(bit_cast<float>(power)) / steps);
    }

    /// The first register has two of every four texels, so both lower halves are where a shuffle needs them.
    UMBRAGE_INLINE static void count(doubles& first, doubles& second) {
        [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE {
            first = doubles{double(I / 2 * 4 + I % 2)...};
        }
        (std::make_integer_sequence<int, Lanes / 2>{});
        second = first + 2.0;
    }
    UMBRAGE_INLINE void round(const doubles& first, const doubles& second, floats& depths) const {
        const doubles a = first + large_, b = second + large_;
        [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE {
            shuffle<(I / 4 * 4 + I % 2 * 2 + I % 4 / 2 * Lanes)...>(reinterpret_cast<floats>(a),
                                                                    reinterpret_cast<floats>(b), depths);
        }
        (std::make_integer_sequence<int, Lanes>{});
    }

private:
    double large_;
};

/// Triangles of a batch to which depths_of_binade applies. Their corners' depths as floats are normal numbers up to 1
/// with one exponent. The plane's depths at the corners are the same floats, so samples, which are between, need no
/// limit.
class triangles_of_binade {
public:
    /// @param batch   after set_up()
    UMBRAGE_INLINE explicit triangles_of_binade(const triangles& batch) {
        using bits = std::int64_t;
        constexpr bits least_normal = bit_cast<bits>(0x1p-126), one = bit_cast<bits>(1.0);
        constexpr bool little = std::endian::native == std::endian::little;
        for (int i = 0; i < block; ++i) {  // numbers above 0 have the order of their bits; others are below them
            const bits a = bit_cast<bits>(batch.corner_depth(0, i)), b = bit_cast<bits>(batch.corner_depth(1, i));
            const bits c = bit_cast<bits>(batch.corner_depth(2, i)), low = a < b ? a : b, high = a < b ? b : a;
            const bits lowest = low < c ? low : c, highest = high > c ? high : c;
            const auto first = bit_cast<std::int32_t>(static_cast<float>(bit_cast<double>(lowest)));
            const auto last = bit_cast<std::int32_t>(static_cast<float>(bit_cast<double>(highest)));
            has_[i] = static_cast<std::int32_t>(-bits((lowest >= least_normal) & (highest <= one))) &
                      -(std::int32_t(little) & std::int32_t(((first ^ last) & 0x7F800000) == 0));
        }
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < block; ++i)
                has_[i] &= -std::int32_t(bit_cast<std::int32_t>(static_cast<float>(batch.depth_at_corner(k, i))) ==
                                         bit_cast<std::int32_t>(static_cast<float>(batch.corner_depth(k, i))));
    }
    [[nodiscard]] UMBRAGE_INLINE bool has(int i) const { return has_[i] != 0; }

private:
    alignas(64) std::int32_t has_[block];  // masks
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
