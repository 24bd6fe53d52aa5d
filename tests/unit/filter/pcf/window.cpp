// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <set>
#include <stdexcept>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/window.hpp>

#include "../../rounds.hpp"
#include "../maps.hpp"
#include "windows.hpp"

using namespace umbrage;

TEST_CASE("window_weights: whole numbers by the formula, for every 1/256 of a texel, that add up to the same") {
    for (const row_in_quarters& of : rows_in_quarters()) {
        const auto& [name, row, quarters, quadratic] = of;
        CAPTURE(of.name);
        for (int moved = 0; moved < 256; ++moved) {
            std::array<double, 16> weights{};
            window_weights(row, moved, weights.data());
            const auto expected = whole_weights(quarters, row.steps, quadratic, moved);
            int different = 0;
            std::int64_t sum = 0;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                different += weights[i] != double(expected[i]);
                CHECK(expected[i] >= 0);
                sum += expected[i];
            }
            CHECK(different == 0);
            CHECK(sum == static_cast<std::int64_t>(row.whole));
        }
    }
}

TEST_CASE("window_sum: brute force in whole numbers, 3 x 3 texels, every fraction, every mask") {
    for (const row_in_quarters& of : rows_in_quarters()) {
        const auto& [name, row, quarters, quadratic] = of;
        if (row.size != 2) continue;
        CAPTURE(of.name);
        int wrong = 0;
        for (int fy = 0; fy < 256;
             fy += (quadratic ? 5 : 1) * one_round_in)  // of the one all, of the other a fifth, for the time
            for (int fx = 0; fx < 256; ++fx) {
                const auto columns = whole_weights(quarters, row.steps, quadratic, fx);
                const auto lines = whole_weights(quarters, row.steps, quadratic, fy);
                int products[9];
                for (std::size_t i = 0; i < 9; ++i) products[i] = int(lines[i / 3] * columns[i % 3]);
                const glm::vec2 coord(5.0f + static_cast<float>(fx) / 256, 7.0f + static_cast<float>(fy) / 256);
                // in the order of a Gray code one texel changes at a time
                int sum = 0;
                unsigned mask = 0;
                for (unsigned n = 0;;) {
                    const auto fetch = [mask](glm::ivec2 t) {
                        return mask >> (3 * (t.y - 6) + (t.x - 4)) & 1 ? 1.0f : 0.0f;
                    };
                    wrong += window_sum(fetch, coord, 0.5f, row) != static_cast<float>(sum);
                    if (++n == 512) break;
                    const unsigned changed = mask ^ (n ^ n >> 1);
                    mask ^= changed;
                    const auto texel = static_cast<std::size_t>(std::countr_zero(changed));
                    sum += mask & changed ? products[texel] : -products[texel];
                }
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("window_sum: brute force in whole numbers, every row of the library, every fraction, in float and double") {
    std::mt19937 random(3);
    for (const row_in_quarters& of : rows_in_quarters()) {
        const auto& [name, row, quarters, quadratic] = of;
        CAPTURE(of.name);
        const int touched = row.size + 1;
        int wrong = 0, partly = 0;
        std::uint64_t mask = 0;
        const glm::ivec2 first = glm::ivec2(9) - row.size / 2;
        const auto fetch = [&](glm::ivec2 t) {
            return mask >> (touched * (t.y - first.y) + (t.x - first.x)) & 1 ? 1.0 : 0.0;
        };
        for (int fy = 0; fy < 256; fy += one_round_in)
            for (int fx = 0; fx < 256; ++fx) {
                mask = std::uint64_t(random()) << 32 | random();
                if (fx % 4 == 1) mask &= std::uint64_t(random()) << 32 | random();
                if (fx % 4 == 2) mask |= std::uint64_t(random()) << 32 | random();
                const auto columns = whole_weights(quarters, row.steps, quadratic, fx);
                const auto lines = whole_weights(quarters, row.steps, quadratic, fy);
                std::int64_t expected = 0, whole = 0;
                for (int i = 0; i < touched * touched; ++i) {
                    const auto weight =
                        lines[static_cast<std::size_t>(i / touched)] * columns[static_cast<std::size_t>(i % touched)];
                    whole += weight;
                    expected += mask >> i & 1 ? weight : 0;
                }
                const double half = row.size % 2 ? 0.5 : 0.0;
                const glm::dvec2 coord(9.0 + half + fx / 256.0, 9.0 + half + fy / 256.0);
                wrong += window_sum(fetch, coord, 0.5, row) != double(expected);
                wrong += window_sum(fetch, glm::vec2(coord), 0.5f, row) != static_cast<float>(expected);
                // the share is the sum times the rounded scale
                const double share = double(expected) / double(whole);
                const float visibility = window(fetch, glm::vec2(coord), 0.5f, row);
                wrong +=
                    !(std::abs(double(visibility) - share) <= (is_power_of_two(row.whole) ? 0.0 : share * 0x1p-23));
                partly += share > 0 && share < 1;
            }
        CHECK(wrong == 0);
        CHECK(partly > rounds(60000));
    }
}

TEST_CASE("window: a single weight is pcf_2x2, equal weights are boxes blended by where the receiver is") {
    std::mt19937 random(5);
    const image<float> map = random_map(random, {12, 9});
    const auto xs = awkward_coordinates(random, 12), ys = awkward_coordinates(random, 9);
    const window_row one = make_window_row(1, {16});
    const window_row three = make_window_row(3, {4, 4}), five = make_window_row(5, {1, 1, 1});
    for (std::size_t i = 0; i < 4000; ++i) {
        const glm::vec2 coord(xs[i * 7 % xs.size()], ys[i * 5 % ys.size()]);
        const float receiver = static_cast<float>(i % 9) / 8.0f;
        CHECK(window(clamped(map), coord, receiver, one) == pcf_2x2(clamped(map), coord, receiver));
        if (std::abs(coord.x) > 32765 || std::abs(coord.y) > 32765) continue;  // boxes further on are outside
        const glm::dvec2 x = glm::floor(glm::dvec2(coord) * 256.0) - 128.0, texel = glm::floor(x / 256.0);
        const glm::dvec2 f = x / 256.0 - texel;
        for (const window_row& row : {three, five}) {
            const auto count = [&](int dx, int dy) {
                return box_count(clamped(map), glm::vec2(texel) + glm::vec2(float(dx), float(dy)) + 0.5f, receiver,
                                 row.size / 2);
            };
            const double blended = (1 - f.y) * ((1 - f.x) * count(0, 0) + f.x * count(1, 0)) +
                                   f.y * ((1 - f.x) * count(0, 1) + f.x * count(1, 1));
            const double scale = double(row.whole) * double(row.whole) / (row.size * row.size);
            CHECK(double(window_sum(clamped(map), coord, receiver, row)) == blended * scale);
        }
    }
}

TEST_CASE("window_sum: fetches each touched texel once, none outside reach") {
    for (int size = 1; size <= max_window; ++size) {
        const window_row row = make_window_row(size, {1, 1, 1, 1, 1, 1, 1, 1});
        CHECK(row.reach() == (static_cast<float>(size) + 1.0f) / 2.0f);
        std::multiset<std::pair<int, int>> seen;
        const auto fetch = [&](glm::ivec2 t) { return seen.insert({t.x, t.y}), 1.0f; };
        const glm::vec2 coord(-3.375f, 20.875f);
        CHECK(window_sum(fetch, coord, 0.5f, row) == row.whole * row.whole);
        CHECK(seen.size() == static_cast<std::size_t>(row.touched() * row.touched()));
        for (const auto& [x, y] : seen) {
            CHECK(seen.count({x, y}) == 1);
            CHECK(std::abs(static_cast<float>(x) + 0.5f - coord.x) < row.reach());
            CHECK(std::abs(static_cast<float>(y) + 0.5f - coord.y) < row.reach());
        }
    }
}

TEST_CASE_TEMPLATE("window: coordinates and depths out of range, maps of one texel", T, float, double) {
    using vec = glm::vec<2, T>;
    const image<T> map({1, 1}, T(0.25));
    const window_row row = make_window_row(5, {1, 4, 6});
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK(window(clamped(map), vec(0.5), T(0.25), row) == 1);
    CHECK(window(clamped(map), vec(0.5), T(0.5), row) == 0);
    CHECK(window(clamped(map), vec(0.5), nan, row) == 0);
    CHECK(window(clamped(map), vec(0.5), infinity, row) == 1);
    CHECK(window(clamped(map), vec(0.5), -infinity, row) == 1);
    CHECK(window(clamped(map), vec(T(32767.99)), T(0.5), row) == 0);
    CHECK(window(bordered(map, T(1)), vec(0.5), T(0.5), row) == T(1) - T(36) / T(256));  // 6/16 an axis
    for (glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(window(clamped(map), vec(outside), T(0.5), row) == 1);
    CHECK(window(clamped(map), vec(0.5), T(0.25), row, greater_equal{}) == 1);
    CHECK(window(clamped(map), vec(0.5), T(0.125), row, greater_equal{}) == 0);
    CHECK(window(clamped(map), vec(0.5), T(-1), row, greater_equal{}) == 1);
}

TEST_CASE("make_window_row: what is no row of weights") {
    CHECK_THROWS_AS((void)make_window_row(0, {1}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(16, {1}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(3, {1, 15}), std::invalid_argument);  // 17 in all
    CHECK_THROWS_AS((void)make_window_row(3, {-1, 15}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(3, {0, 0}), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(3, {1, 2}, 512), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(3, {1, 2}, 96), std::invalid_argument);
    CHECK_THROWS_AS((void)make_window_row(3, {0.3f, 2}), std::invalid_argument);  // 665.6
    CHECK_THROWS_AS((void)make_window_row(3, {1, std::numeric_limits<float>::quiet_NaN()}), std::invalid_argument);
    CHECK(make_window_row(2, {8}).whole == 4096);
    CHECK(make_window_row(7, {1, 5, 12, 16}, 64).whole == 3328);
}
