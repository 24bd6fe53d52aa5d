// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <random>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/adaptive/page_table.hpp>

using namespace umbrage;

TEST_CASE("page_entry: slot, and how many pages of its level the root is wide") {
    CHECK(page_entry({3, 250}, 0) == glm::u8vec4(3, 250, 1, 0));
    CHECK(page_entry({0, 0}, 7) == glm::u8vec4(0, 0, 128, 0));
    CHECK(page_entry({255, 255}, deepest_page_level) == glm::u8vec4(255, 255, 0, 128));
    for (const int beyond : {-1, 31, 40}) (void)page_entry({0, 0}, beyond);  // any entry, but defined
}

TEST_CASE_TEMPLATE("page_coordinate: whole numbers, at every level and page size", T, float, double) {
    std::mt19937 random(7);
    const auto below = [&](std::uint32_t n) { return static_cast<std::int64_t>(random() % n); };
    for (int i = 0; i < 200000; ++i) {
        const auto level = static_cast<int>(below(16)), side = 8 << below(6);
        const std::int64_t one = 1 << 23;
        std::int64_t at[2], page[2], in_page[2];
        for (int axis = 0; axis < 2; ++axis) {
            at[axis] = below(4) ? below(1 << 23) : below(64) << 17;  // at cells' borders, too
            page[axis] = (at[axis] << level) / one;
            in_page[axis] = (at[axis] << level) % one;
        }
        const glm::ivec2 slot(page[0] % 30, page[1] % 30);
        glm::ivec2 read(-1);
        const auto table = [&](glm::ivec2 cell) {
            read = cell;
            return page_entry(slot, level);
        };
        const glm::vec<2, T> coord(T(one + at[0]) / T(one), T(one + at[1]) / T(one));
        const glm::vec<4, T> found = page_coordinate(table, T(66), coord, T(side), T(4));
        const bool right = read == 1 + glm::ivec2(at[0] * 64 / one, at[1] * 64 / one) &&
                           double(found.x - T(4)) * double(one) == double(in_page[0] * side) &&
                           double(found.y - T(4)) * double(one) == double(in_page[1] * side) &&
                           found.z == T(slot.x * (side + 8)) && found.w == T(slot.y * (side + 8));
        CAPTURE(level);
        CAPTURE(side);
        if (!right) CHECK(right);
    }
}

TEST_CASE_TEMPLATE("page_coordinate: beside the root there is no page, nor of NaN", T, float, double) {
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const auto table = [](glm::ivec2 cell) {
        REQUIRE((cell.x >= 0 && cell.y >= 0 && cell.x < 10 && cell.y < 10));
        const bool in_root = cell.x > 0 && cell.y > 0 && cell.x < 9 && cell.y < 9;
        return in_root ? page_entry({1, 2}, 3) : glm::u8vec4(0);
    };
    const auto find = [&](T x, T y) { return page_coordinate(table, T(10), glm::vec<2, T>(x, y), T(16), T(4)); };
    const glm::vec<4, T> no_page(32768, 32768, 0, 0);
    const T last = T(2) - T(0x1p-23), before = T(1) - T(0x1p-24);
    CHECK(find(T(1), last) == glm::vec<4, T>(4, T(20) - T(0x1p-16), 24, 48));
    for (const T beside : {before, T(2), T(0.75), T(0), T(-1e-30), T(-1e30), T(1e30)}) {
        CHECK(find(beside, T(1.5)) == no_page);
        CHECK(find(last, beside) == no_page);
    }
    for (const T none : {-inf, inf, nan}) {
        CHECK_FALSE(inside_texel_space(glm::vec<2, T>(find(none, T(1.5)))));
        CHECK_FALSE(inside_texel_space(glm::vec<2, T>(find(T(1.5), none))));
    }
    CHECK(find(T(1.5), nan).z == 0);
    CHECK(hard([](glm::ivec2) { return T(0); }, glm::vec<2, T>(no_page), T(0.5)) == 1);
}

TEST_CASE("page_tile: eight pages a row") {
    CHECK(page_tile(0, 136) == glm::ivec2(0));
    CHECK(page_tile(7, 136) == glm::ivec2(952, 0));
    CHECK(page_tile(8, 136) == glm::ivec2(0, 136));
    CHECK(page_tile(63, 1) == glm::ivec2(7));
}
