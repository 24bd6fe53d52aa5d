// SPDX-License-Identifier: MIT
//
// The oracle adds up the rectangle texel by texel; for floats, in the order that the docstring gives.
#include "paths.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include <umbrage/images/summed_area.hpp>

#include "../rounds.hpp"
#include "isas.hpp"
#include "last_piece_first.hpp"

namespace {

using paths::gapped;
using umbrage::image;
using umbrage::image_view;

template <class From, class Sum, class Use>
void for_each_table(image_view<From> values, Use&& use) {
    for_each_isa([&] {
        gapped<Sum> whole(values.size), thirds(values.size), rows(values.size);
        umbrage::summed_area(values, whole.view());
        umbrage::summed_area(values, thirds.view(), last_piece_first{3});
        umbrage::summed_area(values, rows.view(), last_piece_first{values.size.y});
        for (gapped<Sum>* table : {&whole, &thirds, &rows}) {
            use(table->view());
            CHECK(table->gaps_untouched());
        }
    });
}

constexpr glm::ivec2 sizes[] = {{1, 1},  {3, 2},   {4, 4},    {1, 37}, {37, 1}, {63, 20},
                                {64, 3}, {65, 30}, {133, 41}, {2, 64}, {7, 65}, {66, 200}};

template <class T>
void check_integers(std::uint32_t greatest) {
    std::mt19937 engine(5);
    for (const glm::ivec2 size : sizes) {
        CAPTURE(size.x);
        gapped<T> values(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                values.view()[{x, y}] = static_cast<T>(engine() % (std::uint64_t(greatest) + 1));
        for_each_table<T, std::uint32_t>(values.view(), [&](image_view<std::uint32_t> sums) {
            int wrong = 0;
            std::vector<std::uint32_t> columns(static_cast<std::size_t>(size.x));
            for (int y = 0; y < size.y; ++y) {
                std::uint32_t sum = 0;
                for (int x = 0; x < size.x; ++x) {
                    sum += columns[static_cast<std::size_t>(x)] += values.view()[{x, y}];
                    wrong += sums[{x, y}] != sum;
                }
            }
            for (int i = 0; i < rounds(200); ++i) {  // rectangles, some beyond a border, some the wrong way round
                const auto any = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n + 8)) - 4; };
                const glm::ivec2 first(any(size.x), any(size.y)), last(any(size.x), any(size.y));
                std::uint32_t sum = 0;
                for (int y = first.y; y <= last.y; ++y)
                    for (int x = first.x; x <= last.x; ++x) sum += umbrage::fetch_bordered(values.view(), {x, y}, T(0));
                wrong += umbrage::box_sum(sums, first, last) != sum;
            }
            CHECK(wrong == 0);
        });
    }
}

}  // namespace

TEST_CASE("summed_area: integers, every rectangle's sum") {
    check_integers<std::uint8_t>(255);
    check_integers<std::uint16_t>(65535);
    check_integers<std::uint32_t>(65535);
}

TEST_CASE("summed_area: integers wrap around, and differences come out right") {
    check_integers<std::uint32_t>(0xFFFFFFFFu);
    image<std::uint32_t> values({100, 100}, 0x00FFFFFFu), sums({100, 100});
    umbrage::summed_area(values.view(), sums.view());
    CHECK(sums[{99, 99}] == static_cast<std::uint32_t>(std::uint64_t(10000) * 0x00FFFFFFu));  // wrapped 39 times
    CHECK(umbrage::box_sum(sums.view(), {50, 60}, {65, 75}) == 256 * 0x00FFFFFFu);            // < 2^32
}

TEST_CASE("summed_area: floats, the order that is documented") {
    std::mt19937 engine(6);
    for (const glm::ivec2 size : sizes) {
        CAPTURE(size.x);
        gapped<float> values(size);
        image<float> wanted(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                values.view()[{x, y}] = static_cast<float>(engine() >> 8) * 0x1p-24f - 0.25f;
        std::vector<float> band(static_cast<std::size_t>(size.x)), under = band;
        for (int y = 0; y < size.y; ++y) {
            if (y % 64 == 0)
                for (std::size_t x = 0; x < band.size(); ++x) under[x] = under[x] + band[x], band[x] = 0.0f;
            float before = 0.0f;
            for (int x = 0; x < size.x; x += 4) {
                float g[4];
                for (int i = 0; i < 4; ++i) g[i] = umbrage::fetch_bordered(values.view(), {x + i, y}, 0.0f);
                const float sums[4] = {g[0], g[0] + g[1], (g[1] + g[2]) + g[0], (g[2] + g[3]) + (g[0] + g[1])};
                for (int i = 0; i < 4 && x + i < size.x; ++i) {
                    const auto column = static_cast<std::size_t>(x + i);
                    band[column] = (before + sums[i]) + band[column];
                    wanted[{x + i, y}] = band[column] + under[column];
                }
                before = before + sums[3];
            }
        }
        for_each_table<float, float>(values.view(), [&](image_view<float> sums) {
            int wrong = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    wrong += std::bit_cast<std::uint32_t>(sums[{x, y}]) != std::bit_cast<std::uint32_t>(wanted[{x, y}]);
            CHECK(wrong == 0);
        });
    }
}

TEST_CASE_TEMPLATE("summed_area: large tables, which bypass the cache", T, std::uint8_t, std::uint16_t, std::uint32_t) {
    std::mt19937 engine(7);
    // Rows on and off multiples of 16 bytes; some and many texels behind the last whole block.
    for (const glm::ivec2 size : {glm::ivec2(1030, 1025), glm::ivec2(1144, 930)}) {
        image<T> values(size);
        image<std::uint32_t> sums(size), pieces(size);
        for (T& v : values.texels()) v = static_cast<T>(engine() % 3 == 0 ? ~0u : engine());
        umbrage::summed_area(values.view(), sums.view());
        umbrage::summed_area(values.view(), pieces.view(), last_piece_first{5});
        std::vector<std::uint32_t> columns(static_cast<std::size_t>(size.x));
        int wrong = 0;
        for (int y = 0; y < size.y; ++y) {
            std::uint32_t sum = 0;
            for (int x = 0; x < size.x; ++x) {
                sum += columns[static_cast<std::size_t>(x)] += values[{x, y}];
                wrong += sums[{x, y}] != sum || pieces[{x, y}] != sum;
            }
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE_TEMPLATE("summed_area: strips of columns, summed in any order", T, std::uint8_t, std::uint16_t, std::uint32_t,
                   float) {
    using sum = std::conditional_t<std::is_same_v<T, float>, float, std::uint32_t>;
    std::mt19937 engine(8);
    const auto bits = [](image<sum>& sums) {
        std::vector<std::uint32_t> all;
        for (sum v : sums.texels()) all.push_back(std::bit_cast<std::uint32_t>(v));
        return all;
    };
    for (const glm::ivec2 size : {glm::ivec2(1025, 3), glm::ivec2(3333, 130), glm::ivec2(8192, 65)}) {
        image<T> values(size);
        for (T& v : values.texels()) v = static_cast<T>(static_cast<float>(engine() >> 8) * 0x1p-24f * 255.0f);
        for_each_isa([&] {
            image<sum> whole(size), backwards(size), forwards(size), halves(size);
            umbrage::summed_area(values.view(), whole.view());
            umbrage::summed_area(values.view(), backwards.view(), last_piece_first{100});
            umbrage::summed_area(values.view(), halves.view(), last_piece_first{2});
            umbrage::summed_area(values.view(), forwards.view(), [](int count, auto&& piece) {
                for (int i = 0; i < count; ++i) piece(i, i + 1);
            });
            const auto wanted = bits(whole);
            CHECK((bits(backwards) == wanted && bits(forwards) == wanted && bits(halves) == wanted));
        });
    }
}

TEST_CASE("summed_area: floats that are small whole numbers are exact") {
    image<float> values({61, 17}, 3.0f), sums({61, 17});
    umbrage::summed_area(values.view(), sums.view());
    CHECK(sums[{60, 16}] == 3.0f * 61 * 17);
    CHECK(umbrage::box_sum(sums.view(), {-5, 2}, {7, 100}) == 3.0f * 8 * 15);
}

TEST_CASE("summed_area: empty images, and sizes that differ") {
    image<std::uint32_t> none, small({3, 3}), large({3, 4});
    umbrage::summed_area(none.view(), none.view());
    umbrage::summed_area(none.view(), none.view(), last_piece_first{2});
    CHECK(umbrage::box_sum(none.view(), {0, 0}, {5, 5}) == 0);
    CHECK_THROWS_AS(umbrage::summed_area(small.view(), large.view()), std::invalid_argument);
}
