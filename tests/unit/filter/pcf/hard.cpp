// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/pcf/hard.hpp>

#include "../maps.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("hard: the receiver's own texel by hand, ties lit, NaN in shadow", T, float, double) {
    image<T> map({2, 2});
    map[{0, 0}] = T(0.25), map[{1, 0}] = T(0.5), map[{0, 1}] = T(0.75), map[{1, 1}] = T(1);
    using vec = glm::vec<2, T>;
    const auto at = [&](T x, T y, T receiver) { return hard(clamped(map), vec(x, y), receiver); };
    CHECK(at(0.5, 0.5, 0.25) == 1);
    CHECK(at(0.5, 0.5, std::nextafter(T(0.25), T(1))) == 0);
    CHECK(at(1, 0.875, 0.5) == 1);  // a texel's lower edge is its own
    CHECK(at(std::nextafter(T(1), T(0)), 0.5, 0.5) == 0);
    CHECK(at(0, 1, 0.75) == 1);
    CHECK(at(1.5, 1.5, 1) == 1);
    CHECK(at(1.5, 1.5, T(1.0001)) == 1);  // beyond the far plane
    CHECK(at(0.5, 0.5, std::numeric_limits<T>::quiet_NaN()) == 0);
    CHECK(at(0.5, 0.5, -std::numeric_limits<T>::infinity()) == 1);
    map[{0, 0}] = std::numeric_limits<T>::quiet_NaN();
    CHECK(at(0.5, 0.5, 0) == 0);
}

TEST_CASE("hard: outside the map, clamped and bordered") {
    image<float> map({2, 1});
    map[{0, 0}] = 0.25f, map[{1, 0}] = 0.75f;
    for (float y : {-100.0f, 0.5f, 100.0f}) {
        CHECK(hard(clamped(map), glm::vec2(-3, y), 0.5f) == 0);
        CHECK(hard(clamped(map), glm::vec2(30, y), 0.5f) == 1);
    }
    CHECK(hard(bordered(map, 1.0f), glm::vec2(-0.001f, 0.5f), 0.5f) == 1);
    CHECK(hard(bordered(map, 0.0f), glm::vec2(2, 0.5f), 0.5f) == 0);
    CHECK(hard(bordered(map, 0.0f), glm::vec2(1.999f, 0.5f), 0.5f) == 1);
    CHECK(hard(bordered(image<float>(), 1.0f), glm::vec2(0.5f), 0.5f) == 1);  // an empty map is all border
}

TEST_CASE("hard: brute force, in float and double") {
    std::mt19937 random(1);
    const glm::ivec2 size(5, 4);
    const image<float> map = random_map(random, size);
    const auto fetch = clamped(map);
    int wrong = 0, lit = 0, tried = 0;
    for (float x : awkward_coordinates(random, size.x))
        for (float y : awkward_coordinates(random, size.y)) {
            const float receiver = static_cast<float>(tried % 9) / 8.0f;
            const double expected =
                texel_at(map, std::llround(std::floor(double(x))), std::llround(std::floor(double(y)))) >= receiver;
            const float got = hard(fetch, glm::vec2(x, y), receiver);
            wrong += got != expected;
            wrong += hard(fetch, glm::dvec2(x, y), double(receiver)) != expected;
            lit += got == 1;
            ++tried;
        }
    CHECK(wrong == 0);
    CHECK(lit > tried / 4);
    CHECK(lit < tried * 3 / 4);
}
