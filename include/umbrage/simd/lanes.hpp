// SPDX-License-Identifier: MIT
//
// Vector registers: several values side by side, with one operation on all of them.
//
//     lanes_of<float, 8> depths;
//     load_lanes(texels, depths);  // with + - & and [] of the language
//
// These are the compiler's own vectors, which need no header and no knowledge of the machine. plain_lanes.hpp gives the
// same bits for compilers without them, and for tests. It also documents each function. Vectors are passed by
// reference: by value, the calling convention depends on the instruction set.
#pragma once

#include <cstdint>
#include <cstring>
#include <utility>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/plain_lanes.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

#if defined(__GNUC__) || defined(__clang__)
/// True when the compiler has its own vectors, with all operators of the language.
inline constexpr bool has_lanes = true;

template <class T, int Count>
struct compiler_lanes {
    typedef T type __attribute__((vector_size(Count * sizeof(T))));
};
template <class T, int Count>
using lanes_of = typename compiler_lanes<T, Count>::type;
#else
inline constexpr bool has_lanes = false;
template <class T, int Count>
using lanes_of = plain_lanes<T, Count>;
#endif

/// Lanes from memory of any alignment, and back.
template <class Lanes>
UMBRAGE_INLINE inline void load_lanes(const void* from, Lanes& v) {
    std::memcpy(&v, from, sizeof v);
}
template <class Lanes>
UMBRAGE_INLINE inline void store_lanes(const Lanes& v, void* to) {
    std::memcpy(to, &v, sizeof v);
}

#if defined(__GNUC__) || defined(__clang__)
template <int... From, class Lanes, class Result>
UMBRAGE_INLINE inline void shuffle(const Lanes& a, const Lanes& b, Result& result) {
#if __has_builtin(__builtin_shufflevector)
    result = __builtin_shufflevector(a, b, From...);
#else  // GCC 11
    constexpr int count = sizeof(Lanes) / sizeof(a[0]);
    result = Result{(From < count ? a[From % count] : b[From % count])...};
#endif
}

/// Lanes 0, 1, 2 ...
template <class T, int Count>
UMBRAGE_INLINE inline void count_lanes(lanes_of<T, Count>& v) {
    [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE { v = lanes_of<T, Count>{T(I)...}; }
    (std::make_integer_sequence<int, Count>{});
}

/// Lanes of `low`, then those of `high`, each converted to half as many bits.
template <class T, int Count, class Half>
UMBRAGE_INLINE inline void narrow_lanes(const Half& low, const Half& high, lanes_of<T, Count>& v) {
    using half = lanes_of<T, Count / 2>;
    [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE {
        shuffle<I...>(__builtin_convertvector(low, half), __builtin_convertvector(high, half), v);
    }
    (std::make_integer_sequence<int, Count>{});
}

template <class Lanes>
UMBRAGE_INLINE inline void keep_least(const Lanes& v, Lanes& least) {
    least = v < least ? v : least;
}
template <class Lanes>
UMBRAGE_INLINE inline void keep_greatest(const Lanes& v, Lanes& greatest) {
    greatest = v > greatest ? v : greatest;
}

template <int Count, bool Forward>
UMBRAGE_INLINE inline void lit_lanes(float receiver, const lanes_of<float, Count>& stored,
                                     lanes_of<std::int32_t, Count>& lit) {
    if constexpr (Forward) lit = receiver <= stored;
    else lit = receiver >= stored;
    if constexpr (finite_math_only)
        lit &= (reinterpret_cast<lanes_of<std::int32_t, Count>>(stored) & 0x7FFFFFFF) <= 0x7F800000;
}

template <int Count>
UMBRAGE_INLINE inline void add_where(const lanes_of<std::int32_t, Count>& mask, float weight,
                                     lanes_of<float, Count>& sum) {
    const lanes_of<std::int32_t, Count> weights = mask & detail::bit_cast<std::int32_t>(weight);
    sum += reinterpret_cast<lanes_of<float, Count>>(weights);
}

template <int Count>
UMBRAGE_INLINE inline void keep_where(const lanes_of<std::int32_t, Count>& mask, lanes_of<float, Count>& v) {
    v = reinterpret_cast<lanes_of<float, Count>>(mask & reinterpret_cast<lanes_of<std::int32_t, Count>>(v));
}

template <int Count, bool Forward>
UMBRAGE_INLINE inline void compare_on_plane(float slope, float first, float x, float beside, float receiver,
                                            lanes_of<float, Count>& texels) {
    using bits = lanes_of<std::int32_t, Count>;
    lanes_of<float, Count> column;
    count_lanes<float, Count>(column);
    const lanes_of<float, Count> zero{}, all = zero + receiver;
    const lanes_of<float, Count> plane = (all + slope * (column + first - x)) + beside;
    bits lit;
    if constexpr (Forward) lit = (plane < all ? plane : all) <= texels;
    else lit = (plane > all ? plane : all) >= texels;
    if constexpr (finite_math_only) lit &= (reinterpret_cast<bits>(texels) & 0x7FFFFFFF) <= 0x7F800000;
    texels = lit ? zero + (Forward ? 1.0f : 0.0f) : texels;
}

template <int Count>
UMBRAGE_INLINE inline void add_products(const lanes_of<float, Count>& a, const lanes_of<float, Count>& b,
                                        lanes_of<float, 4>& sums) {
    const lanes_of<float, Count> products = a * b;
    lanes_of<float, 4> part;
    std::memcpy(&part, &products, sizeof part);
    sums += part;
    if constexpr (Count == 8) {
        std::memcpy(&part, reinterpret_cast<const char*>(&products) + sizeof part, sizeof part);
        sums += part;
    }
}

template <class Four>
UMBRAGE_INLINE inline void sum_four_lanes(const Four& a, const Four& b, const Four& c, const Four& d, Four& sums) {
    Four even, odd, first, second;
    shuffle<0, 4, 1, 5>(a, b, even);
    shuffle<2, 6, 3, 7>(a, b, odd);
    first = even + odd;
    shuffle<0, 4, 1, 5>(c, d, even);
    shuffle<2, 6, 3, 7>(c, d, odd);
    second = even + odd;
    shuffle<0, 1, 4, 5>(first, second, even);
    shuffle<2, 3, 6, 7>(first, second, odd);
    sums = even + odd;
}

#if defined(__x86_64__) && !defined(__clang__)
// Inlined into code compiled for AVX2, whose builtins dispatch.hpp has declared.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
UMBRAGE_INLINE inline std::uint32_t mask_bits(const lanes_of<std::int32_t, 8>* masks) {
    const auto first = __builtin_ia32_packssdw256(masks[0], masks[1]);  // the halves of registers stay separate
    const auto second = __builtin_ia32_packssdw256(masks[2], masks[3]);
    return static_cast<std::uint32_t>(__builtin_ia32_pmovmskb256(__builtin_ia32_packsswb256(first, second)));
}
#pragma GCC diagnostic pop
#elif defined(__GNUC__) || defined(__clang__)
UMBRAGE_INLINE inline std::uint32_t mask_bits(const lanes_of<std::int32_t, 8>* masks) {
    using bits = lanes_of<std::int32_t, 8>;
    const bits rows = (masks[0] & 1) + (masks[1] & 16) + (masks[2] & 256) + (masks[3] & 4096);
    const bits placed = rows << bits{0, 1, 2, 3, 16, 17, 18, 19};
    lanes_of<std::int32_t, 4> halves[2];
    std::memcpy(halves, &placed, sizeof halves);
    const auto all = halves[0] | halves[1];
    return static_cast<std::uint32_t>(all[0] | all[1] | all[2] | all[3]);
}
#endif

template <int Count>
UMBRAGE_INLINE inline void sum_two_lanes(const lanes_of<std::int32_t, Count>& first,
                                         const lanes_of<std::int32_t, Count>& second, std::int32_t* sums) {
    using four = lanes_of<std::int32_t, 4>;
    const auto to_four = [](const auto& numbers) UMBRAGE_INLINE {
        four parts[std::size_t(Count) / 4], sum{};
        std::memcpy(parts, &numbers, sizeof parts);
        for (const four& part : parts) sum += part;
        return sum;
    };
    const four a = to_four(first), b = to_four(second);
#if defined(__x86_64__)
    using bytes = compiler_lanes<char, 16>::type;
    const auto halves = reinterpret_cast<bytes>(__builtin_ia32_packssdw128(a, b));
    const auto wide = reinterpret_cast<four>(__builtin_ia32_psadbw128(halves, bytes{}));  // adds bytes, eight at a time
    const auto both = __builtin_ia32_packssdw128(wide, wide);
    std::memcpy(sums, &both, 2 * sizeof *sums);
#else
    sums[0] = a[0] + a[1] + a[2] + a[3];
    sums[1] = b[0] + b[1] + b[2] + b[3];
#endif
}
#endif

/// Running sum of the lanes, in groups of four: v0, v0+v1, (v1+v2)+v0, (v2+v3)+(v0+v1).
template <int Count, class Lanes>
UMBRAGE_INLINE inline void running_sum(Lanes& v) {
    const auto add_moved = [&]<int... From>() UMBRAGE_INLINE {
        Lanes moved;
        shuffle<From...>(Lanes{}, v, moved);
        v = v + moved;
    };
    static_assert(Count == 4 || Count == 8);
    if constexpr (Count == 8) {
        add_moved.template operator()<0, 8, 9, 10, 11, 12, 13, 14>();
        add_moved.template operator()<0, 1, 8, 9, 10, 11, 12, 13>();
        add_moved.template operator()<0, 1, 2, 3, 8, 9, 10, 11>();
    } else {
        add_moved.template operator()<0, 4, 5, 6>();
        add_moved.template operator()<0, 1, 4, 5>();
    }
}

/// Running sums of bytes, in groups of eight. They fit 16 bits, and registers hold twice as many of those.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
inline constexpr bool sums_bytes = true;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
UMBRAGE_INLINE inline void running_sums_of_bytes(const std::uint8_t* from, lanes_of<std::uint32_t, 8>& first,
                                                 lanes_of<std::uint32_t, 8>& second) {
    using halves = compiler_lanes<long long, 4>::type;
    using numbers = compiler_lanes<short, 16>::type;
    compiler_lanes<char, 16>::type bytes;
    load_lanes(from, bytes);
    numbers v = __builtin_ia32_pmovzxbw256(bytes);
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 16));
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 32));
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 64));
    compiler_lanes<short, 8>::type half[2];
    std::memcpy(half, &v, sizeof half);
    first = reinterpret_cast<lanes_of<std::uint32_t, 8>>(__builtin_ia32_pmovzxwd256(half[0]));
    second = reinterpret_cast<lanes_of<std::uint32_t, 8>>(__builtin_ia32_pmovzxwd256(half[1]));
}
#pragma GCC diagnostic pop
#else
inline constexpr bool sums_bytes = false;
#endif

/// Last lane, copied to all of them.
template <int Count, class Lanes>
UMBRAGE_INLINE inline void all_last(Lanes& v) {
    Lanes last;
    if constexpr (Count == 8) shuffle<7, 7, 7, 7, 7, 7, 7, 7>(v, v, last);
    else shuffle<3, 3, 3, 3>(v, v, last);
    v = last;
}

/// Number of lanes of a running sum where registers have eight. clang 14 is slower with eight than with four.
#if defined(__GNUC__) && !defined(__clang__)
inline constexpr int running_sum_lanes = 8;
#else
inline constexpr int running_sum_lanes = 4;
#endif

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
