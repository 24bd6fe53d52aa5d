// SPDX-License-Identifier: MIT
//
// Registers: the compiler's vectors and plain_lanes give the same bits.
//
#include <umbrage/simd/lanes.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <umbrage/simd/dispatch.hpp>

using namespace umbrage::detail;

namespace {

template <class Lanes, class T, int Count>
void check_running_sum_of(const T (&values)[Count], const T (&expected)[Count]) {
    Lanes lanes;
    T results[Count];
    load_lanes(values, lanes);
    running_sum<Count>(lanes);
    store_lanes(lanes, results);
    CHECK(std::memcmp(results, expected, sizeof results) == 0);
    all_last<Count>(lanes);
    store_lanes(lanes, results);
    for (T last : results) CHECK(last == expected[Count - 1]);
}
template <class T, int Count>
void check_running_sum(const T (&values)[Count], const T (&expected)[Count]) {
    check_running_sum_of<lanes_of<T, Count>>(values, expected);
    check_running_sum_of<plain_lanes<T, Count>>(values, expected);
}

template <template <class, int> class Lanes, int Count>
void check_lit() {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const float stored[]{0.25f, 0.5f, 0.75f, nan, -infinity, infinity, -nan, -0.0f};
    const bool lit[]{false, true, true, false, false, true, false, false};
    for (int first = 0; first < 8; first += Count) {
        Lanes<float, Count> depths;
        Lanes<std::int32_t, Count> mask;
        load_lanes(stored + first, depths);
        lit_lanes<Count, true>(0.5f, depths, mask);
        std::int32_t results[Count];
        store_lanes(mask, results);
        for (int i = 0; i < Count; ++i) CHECK(results[i] == (lit[first + i] ? -1 : 0));
    }
}

template <template <class, int> class Lanes, int Count>
void check_sum_two() {
    Lanes<std::int32_t, Count> first{}, second{};
    for (int i = 0; i < Count; ++i) {
        first[i] = 127;
        second[i] = i;
    }
    std::int32_t sums[2];
    sum_two_lanes<Count>(first, second, sums);
    CHECK(sums[0] == 127 * Count);
    CHECK(sums[1] == Count * (Count - 1) / 2);
}

template <template <class, int> class Lanes>
void check_keep() {
    Lanes<float, 4> low, high;
    Lanes<float, 8> all;
    Lanes<std::int32_t, 8> mask;
    for (int i = 0; i < 4; ++i) low[i] = float(i), high[i] = float(4 + i);
    shuffle<0, 1, 2, 3, 4, 5, 6, 7>(low, high, all);
    for (int i = 0; i < 8; ++i) CHECK(float(all[i]) == float(i));
    for (int i = 0; i < 8; ++i) mask[i] = -(i % 3 == 0);
    keep_where<8>(mask, all);
    for (int i = 0; i < 8; ++i) CHECK(float(all[i]) == (i % 3 == 0 ? float(i) : 0.0f));
    shuffle<6, 6, 3, 0>(all, all, low);
    CHECK(float(low[0]) == 6.0f);
    CHECK(float(low[1]) == 6.0f);
    CHECK(float(low[2]) == 3.0f);
    CHECK(float(low[3]) == 0.0f);
}

template <template <class, int> class Lanes>
void check_least() {
    Lanes<std::int32_t, 4> v, least, greatest;
    for (int i = 0; i < 4; ++i) v[i] = i - 2, least[i] = greatest[i] = -1;
    v[3] = std::numeric_limits<std::int32_t>::min();
    keep_least(v, least);
    keep_greatest(v, greatest);
    const std::int32_t low[]{-2, -1, -1, std::numeric_limits<std::int32_t>::min()}, high[]{-1, -1, 0, -1};
    for (int i = 0; i < 4; ++i) {
        CHECK(std::int32_t(least[i]) == low[i]);
        CHECK(std::int32_t(greatest[i]) == high[i]);
    }
}

/// Texels 5 and on, around a receiver at column 7 of a plane that comes nearer by 1/16 a column.
template <template <class, int> class Lanes, int Count>
void check_plane() {
    Lanes<float, Count> lit, dark;
    for (int i = 0; i < Count; ++i) {
        const float reference = 0.5f - (i > 2 ? 0.0625f * static_cast<float>(i - 2) : 0.0f);
        lit[i] = reference, dark[i] = reference - 0x1p-20f;
    }
    const Lanes<float, Count> stored = dark;
    compare_on_plane<Count, true>(-0.0625f, 5.0f, 7.0f, 0.0f, 0.5f, lit);
    compare_on_plane<Count, true>(-0.0625f, 5.0f, 7.0f, 0.0f, 0.5f, dark);
    for (int i = 0; i < Count; ++i) CHECK((float(lit[i]) == 1.0f && float(dark[i]) == float(stored[i])));
    for (int i = 0; i < Count; ++i) {
        const float reference = 0.5f + (i > 2 ? 0.0625f * static_cast<float>(i - 2) : 0.0f);
        lit[i] = reference, dark[i] = reference + 0x1p-20f;
    }
    const Lanes<float, Count> nearer = dark;
    compare_on_plane<Count, false>(0.0625f, 5.0f, 7.0f, 0.0f, 0.5f, lit);
    compare_on_plane<Count, false>(0.0625f, 5.0f, 7.0f, 0.0f, 0.5f, dark);
    for (int i = 0; i < Count; ++i) CHECK((float(lit[i]) == 0.0f && float(dark[i]) == float(nearer[i])));
}

}  // namespace

TEST_CASE("lanes: texels are compared along a plane where that is nearer to the light") {
    check_plane<lanes_of, 4>();
    check_plane<lanes_of, 8>();
    check_plane<plain_lanes, 4>();
    check_plane<plain_lanes, 8>();
}

TEST_CASE("lanes: a running sum, and its last in all lanes") {
    check_running_sum<std::uint32_t, 4>({1, 2, 0xFFFFFFFF, 7}, {1, 3, 2, 9});
    check_running_sum<std::uint32_t, 8>({1, 2, 3, 4, 5, 6, 7, 8}, {1, 3, 6, 10, 15, 21, 28, 36});
}

TEST_CASE("lanes: floats are summed in the order that is stated") {
    // (v1 + v2) + v0 keeps the 1 that (v0 + v1) + v2 loses.
    check_running_sum<float, 4>({0x1p24f, 1.0f, 1.0f, 2.0f}, {0x1p24f, 0x1p24f, 0x1p24f + 2.0f, 0x1p24f + 4.0f});
}

TEST_CASE("lanes: a lane is lit where its depth is not nearer, and NaN never is") {
    check_lit<lanes_of, 4>();
    check_lit<lanes_of, 8>();
    check_lit<plain_lanes, 4>();
    check_lit<plain_lanes, 8>();
}

TEST_CASE("lanes: sums of two registers") {
    check_sum_two<lanes_of, 4>();
    check_sum_two<lanes_of, 8>();
    check_sum_two<plain_lanes, 4>();
    check_sum_two<plain_lanes, 8>();
}

TEST_CASE("lanes: what a mask leaves out is zero, and shuffles give as many lanes as they name") {
    check_keep<lanes_of>();
    check_keep<plain_lanes>();
}

TEST_CASE("lanes: the least and the greatest, lane by lane") {
    check_least<lanes_of>();
    check_least<plain_lanes>();
}

TEST_CASE("lanes: masks become bits, four lanes of four masks and then the others") {
    std::int32_t masks[4][8];
    plain_lanes<std::int32_t, 8> plain[4];
    for (int bit = 0; bit < 32; ++bit) {
        for (int i = 0; i < 32; ++i) masks[i / 8][i % 8] = -((i / 8) * 4 + (i % 8 / 4) * 16 + i % 4 == bit);
        std::memcpy(plain, masks, sizeof plain);
        CHECK(mask_bits(plain) == 1u << bit);
        on_best_isa([&](auto set) UMBRAGE_INLINE {
            if constexpr (set != isa::base) {
                lanes_of<std::int32_t, 8> lanes[4];
                std::memcpy(lanes, masks, sizeof lanes);
                CHECK(mask_bits(lanes) == 1u << bit);
            }
        });
    }
}

TEST_CASE("lanes: arithmetic of plain lanes is the language's, lane by lane") {
    using four = plain_lanes<std::int32_t, 4>;
    const four a{{1, 2, 3, 4}}, b{{16, 6, 1, 5}};
    for (int i = 0; i < 4; ++i) {
        CHECK((a + b)[i] == a[i] + b[i]);
        CHECK((a - b)[i] == a[i] - b[i]);
        CHECK((a * b)[i] == a[i] * b[i]);
        CHECK((a & b)[i] == (a[i] & b[i]));
    }
}
