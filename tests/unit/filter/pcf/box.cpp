// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>

#include "../maps.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("box: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    image<T> map({3, 3}, T(0));
    map[{1, 1}] = T(0.5), map[{2, 2}] = T(1), map[{0, 0}] = T(1);
    CHECK(box_count(clamped(map), vec(1.5), T(0.5), 1) == 3);
    CHECK(box_count(clamped(map), vec(1.5), T(0.75), 1) == 2);
    CHECK(box_count(clamped(map), vec(1, 1.999), T(0.5), 0) == 1);
    CHECK(box_count(clamped(map), vec(0.5), T(0.75), 1) == 4);  // the corner texel counts for what lies beyond it
    CHECK(box_count(bordered(map, T(0)), vec(0.5), T(0.75), 1) == 1);
    CHECK(box_count(bordered(map, T(1)), vec(0.5), T(0.75), 1) == 6);
    CHECK(box_count(clamped(map), vec(1.5), std::numeric_limits<T>::quiet_NaN(), 1) == 0);
    CHECK(box(clamped(map), vec(1.5), T(0.5), 1) == T(3) * (T(1) / T(9)));
    CHECK(box(clamped(map), vec(1.5), T(0), 1) == 1);
}

TEST_CASE("box_count: brute force for every radius, in float and double, radius clamped to 0..8") {
    std::mt19937 random(1);
    const glm::ivec2 size(11, 7);
    const image<float> map = random_map(random, size);
    const auto fetch = clamped(map);
    const auto xs = awkward_coordinates(random, size.x), ys = awkward_coordinates(random, size.y);
    int wrong = 0, partly = 0;
    for (int radius :
         {0, 1, 2, 3, 4, 5, 6, 7, 8, -1, 9, 1000, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
        for (std::size_t i = 0; i < 500; ++i) {
            const glm::vec2 c(xs[i * 7 % xs.size()], ys[i * 5 % ys.size()]);
            const float receiver = static_cast<float>(i % 9) / 8.0f;
            const int r = std::clamp(radius, 0, 8);
            const long long x = std::llround(std::floor(double(c.x))), y = std::llround(std::floor(double(c.y)));
            int expected = 0;
            for (long long ty = y - r; ty <= y + r; ++ty)
                for (long long tx = x - r; tx <= x + r; ++tx) expected += texel_at(map, tx, ty) >= receiver;
            const float got = box_count(fetch, c, receiver, radius);
            wrong += got != static_cast<float>(expected);
            wrong += box_count(fetch, glm::dvec2(c), double(receiver), radius) != expected;
            if (radius == 0) wrong += got != hard(fetch, c, receiver);
            // the share is the correctly rounded count times the correctly rounded scale
            const double share = double(expected) / ((2 * r + 1) * (2 * r + 1));
            wrong += !(std::abs(box(fetch, c, receiver, radius) - share) <= share * 0x1p-23);
            partly += share > 0 && share < 1;
        }
    CHECK(wrong == 0);
    CHECK(partly > 1000);
}

TEST_CASE("box_count: fetches each texel of the box once") {
    for (int radius = 0; radius <= max_box_radius; ++radius) {
        std::multiset<std::pair<int, int>> seen;
        const auto fetch = [&](glm::ivec2 t) { return seen.insert({t.x, t.y}), 1.0f; };
        (void)box_count(fetch, glm::vec2(-3.5f, 20.25f), 0.5f, radius);
        CHECK(seen.size() == static_cast<std::size_t>((2 * radius + 1) * (2 * radius + 1)));
        for (int y = 20 - radius; y <= 20 + radius; ++y)
            for (int x = -4 - radius; x <= -4 + radius; ++x) CHECK(seen.count({x, y}) == 1);
    }
}

TEST_CASE_TEMPLATE("box: all lit is exactly 1, all dark exactly 0, one texel less is less, for every radius", T, float,
                   double) {
    for (int radius = -1; radius <= 9; ++radius) {
        const glm::vec<2, T> c(5.5);
        CHECK(box([](glm::ivec2) { return T(0.5); }, c, T(0.5), radius) == T(1));
        CHECK(box([](glm::ivec2) { return T(0.25); }, c, T(0.5), radius) == T(0));
        // every count in between, in order
        const int r = std::clamp(radius, 0, 8), taps = (2 * r + 1) * (2 * r + 1);
        T before = -1;
        for (int lit = 0; lit <= taps; ++lit) {
            int k = 0;
            const T v = box([&](glm::ivec2) { return k++ < lit ? T(1) : T(0); }, c, T(0.5), radius);
            CHECK(v > before);
            before = v;
        }
        CHECK(before == T(1));
    }
}

TEST_CASE("box_scale: rounded to nearest, from its own radius range") {
    for (int radius = -2; radius <= 12; ++radius) {
        const int width = 2 * std::clamp(radius, 0, 8) + 1;
        CHECK(box_scale<double>(radius) == 1.0 / (width * width));
        CHECK(box_scale<float>(radius) == static_cast<float>(1.0 / (width * width)));
    }
    static_assert(box_scale<float>(2) == 0.04f);
}

TEST_CASE("box: moving map and receiver together changes nothing, mirroring and turning both neither") {
    std::mt19937 random(2);
    const image<float> map = random_map(random, {16, 16});
    std::uniform_int_distribution<int> position(-64, 17 * 32), shift(-30000, 30000);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 coord = (glm::vec2(position(random), position(random)) + 0.5f) / 32.0f;
        const float receiver = static_cast<float>(i % 9) / 8.0f;
        const int radius = i % 9;
        const float here = box(clamped(map), coord, receiver, radius);
        const glm::ivec2 by(shift(random), shift(random));
        const auto moved = [&](glm::ivec2 t) { return fetch_clamped(map.view(), t - by); };
        CHECK(box(moved, coord + glm::vec2(by), receiver, radius) == here);
        const auto mirrored = [&](glm::ivec2 t) { return fetch_clamped(map.view(), {-1 - t.x, t.y}); };
        CHECK(box(mirrored, glm::vec2(-coord.x, coord.y), receiver, radius) == here);
        const auto turned = [&](glm::ivec2 t) { return fetch_clamped(map.view(), {t.y, t.x}); };
        CHECK(box(turned, glm::vec2(coord.y, coord.x), receiver, radius) == here);
    }
}
