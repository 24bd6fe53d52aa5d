// SPDX-License-Identifier: MIT
//
// Functions of lanes.hpp for any compiler: arrays instead of registers, and loops.
//
#pragma once

#include <cstddef>
#include <cstdint>

#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

template <class T, int Count>
struct plain_lanes {
    T at[std::size_t(Count)];

    T& operator[](int i) { return at[i]; }
    const T& operator[](int i) const { return at[i]; }

    plain_lanes& operator+=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] += b.at[i];
        return *this;
    }
    plain_lanes& operator-=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] -= b.at[i];
        return *this;
    }
    plain_lanes& operator*=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] *= b.at[i];
        return *this;
    }
    plain_lanes& operator&=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] &= b.at[i];
        return *this;
    }
    friend plain_lanes operator+(plain_lanes a, const plain_lanes& b) { return a += b; }
    friend plain_lanes operator-(plain_lanes a, const plain_lanes& b) { return a -= b; }
    friend plain_lanes operator*(plain_lanes a, const plain_lanes& b) { return a *= b; }
    friend plain_lanes operator&(plain_lanes a, const plain_lanes& b) { return a &= b; }
};

/// Lanes selected from two registers: lane i of the result is lane From[i] of a followed by b. Lanes have 32 bits.
template <int... From, class T, int Count>
inline void shuffle(const plain_lanes<T, Count>& a, const plain_lanes<T, Count>& b,
                    plain_lanes<T, int(sizeof...(From))>& result) {
    result = {{(From < Count ? a[From % Count] : b[From % Count])...}};
}

/// Minimum, or maximum, of each lane of both.
template <class T, int Count>
inline void keep_least(const plain_lanes<T, Count>& v, plain_lanes<T, Count>& least) {
    for (int i = 0; i < Count; ++i) least[i] = v[i] < least[i] ? v[i] : least[i];
}
template <class T, int Count>
inline void keep_greatest(const plain_lanes<T, Count>& v, plain_lanes<T, Count>& greatest) {
    for (int i = 0; i < Count; ++i) greatest[i] = v[i] > greatest[i] ? v[i] : greatest[i];
}

/// is_lit, or is_lit with its arguments exchanged, as a mask per lane. The receiver is not NaN.
template <int Count, bool Forward>
inline void lit_lanes(float receiver, const plain_lanes<float, Count>& stored, plain_lanes<std::int32_t, Count>& lit) {
    for (int i = 0; i < Count; ++i) lit[i] = -(Forward ? is_lit(receiver, stored[i]) : is_lit(stored[i], receiver));
}

/// Sum of the lanes of each of two registers, of 4 or 8 numbers between 0 and 127.
template <int Count>
inline void sum_two_lanes(const plain_lanes<std::int32_t, Count>& first, const plain_lanes<std::int32_t, Count>& second,
                          std::int32_t* sums) {
    sums[0] = sums[1] = 0;
    for (int i = 0; i < Count; ++i) {
        sums[0] += first[i];
        sums[1] += second[i];
    }
}

/// Four masks of eight lanes as bits: bit 4 i + k is lane k of mask i, bit 16 + 4 i + k its lane 4 + k.
inline std::uint32_t mask_bits(const plain_lanes<std::int32_t, 8>* masks) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 32; ++i) bits |= static_cast<std::uint32_t>(masks[i / 4 % 4][i / 16 * 4 + i % 4] & 1) << i;
    return bits;
}

/// Adds the weight to the lanes of a mask.
template <int Count>
inline void add_where(const plain_lanes<std::int32_t, Count>& mask, float weight, plain_lanes<float, Count>& sum) {
    for (int i = 0; i < Count; ++i) sum[i] += masked(weight, mask[i]);
}

/// Sets the lanes outside a mask to zero.
template <int Count>
inline void keep_where(const plain_lanes<std::int32_t, Count>& mask, plain_lanes<float, Count>& v) {
    for (int i = 0; i < Count; ++i) v[i] = masked(v[i], mask[i]);
}

/// apply_receiver_plane of a row of texels from column `first` on.
/// @param slope      slope of the receiver, along the row
/// @param x          position of the receiver less half a texel, along the row
/// @param beside     depth that the row's distance from the receiver adds to the plane
/// @param receiver   depth of the receiver; not NaN
template <int Count, bool Forward>
inline void compare_on_plane(float slope, float first, float x, float beside, float receiver,
                             plain_lanes<float, Count>& texels) {
    for (int i = 0; i < Count; ++i) {
        const float plane = (receiver + slope * (static_cast<float>(i) + first - x)) + beside;
        texels[i] = lit_on_plane<Forward>(receiver, plane, texels[i]);
    }
}

/// Adds products to a register of four, lane by lane, wrapping around. None of them rounds.
template <int Count>
inline void add_products(const plain_lanes<float, Count>& a, const plain_lanes<float, Count>& b,
                         plain_lanes<float, 4>& sums) {
    for (int i = 0; i < Count; ++i) sums[i % 4] += a[i] * b[i];
}

/// Sum of the lanes of each of four registers.
template <class T>
inline void sum_four_lanes(const plain_lanes<T, 4>& a, const plain_lanes<T, 4>& b, const plain_lanes<T, 4>& c,
                           const plain_lanes<T, 4>& d, plain_lanes<T, 4>& sums) {
    for (int k = 0; const auto* v : {&a, &b, &c, &d}) sums[k++] = (*v)[0] + (*v)[1] + (*v)[2] + (*v)[3];
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
