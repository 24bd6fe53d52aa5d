// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/cascades/select.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/filter/pcf/hard.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("cascade_by_depth: counts the ends that a depth has reached", T, float, double) {
    const glm::vec<3, T> ends(T(2), T(5), T(20));
    const T infinity = std::numeric_limits<T>::infinity();
    for (const T depth : {T(-1), T(0), T(1.99), T(2), T(4.99), T(5), T(19.99), T(20), T(1000), infinity}) {
        int reached = 0;
        for (glm::length_t i = 0; i < 3; ++i) reached += depth >= ends[i];
        CHECK(cascade_by_depth(depth, ends) == T(reached));
    }
    CHECK(cascade_by_depth(std::numeric_limits<T>::quiet_NaN(), ends) == T(0));
    CHECK(cascade_by_depth(T(1e9), glm::vec<3, T>(T(2), infinity, infinity)) == T(1));
}

TEST_CASE("cascade_by_depth: of six ends three and three") {
    const glm::vec3 near(1, 2, 3), far(4, 5, 6);
    for (int i = 0; i < 7; ++i) {
        const float depth = static_cast<float>(i) + 0.5f;
        CHECK(cascade_by_depth(depth, near) + cascade_by_depth(depth, far) == static_cast<float>(i));
    }
}

TEST_CASE("cascade_column: the column of that number") {
    glm::mat4 m(0.0f);
    for (glm::length_t i = 0; i < 4; ++i) m[i] = glm::vec4(static_cast<float>(i), 7.0f, 8.0f, 9.0f);
    for (const float number : {0.0f, 1.0f, 2.0f, 3.0f}) CHECK(cascade_column(m, number).x == number);
    CHECK(cascade_column(m, 4.0f).x == 3.0f);
}

TEST_CASE_TEMPLATE("cascade_coordinate: a scale and an offset", T, float, double) {
    const glm::vec<3, T> at =
        cascade_coordinate(glm::vec<3, T>(T(1), T(-2), T(4)), glm::vec<4, T>(T(10), T(20), T(0.125), T(99)),
                           glm::vec<4, T>(T(512), T(511.5), T(0.25), T(99)));
    CHECK(at == glm::vec<3, T>(T(522), T(471.5), T(0.75)));
}

TEST_CASE_TEMPLATE("inside_cascade: as far from every side as the filter reaches", T, float, double) {
    const glm::vec<2, T> size(T(64), T(32));
    const auto inside = [&](double x, double y, double z) {
        return inside_cascade(glm::vec<3, T>(T(x), T(y), T(z)), size, T(2.5));
    };
    CHECK(inside(2.5, 2.5, 0));
    CHECK(inside(61.5, 29.5, 1));
    CHECK(!inside(2.4375, 16, 0.5));
    CHECK(!inside(61.5625, 16, 0.5));
    CHECK(!inside(32, 2.4375, 0.5));
    CHECK(!inside(32, 29.5625, 0.5));
    CHECK(!inside(32, 16, -0.001));
    CHECK(!inside(32, 16, 1.001));
    const double nan = std::nan("");
    CHECK(!inside(nan, 16, 0.5));
    CHECK(!inside(32, nan, 0.5));
    CHECK(!inside(32, 16, nan));
}

TEST_CASE("cascade_by_projection: the first that inside_cascade takes, of nested and of shifted ones") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    const glm::vec2 size(64, 64);
    int seen[5]{};
    for (int i = 0; i < 4000; ++i) {
        glm::mat4 scales(0.0f), offsets(0.0f);
        for (glm::length_t k = 0; k < 4; ++k) {
            const float scale = 16.0f / static_cast<float>(1 << k), dx = unit(random), dy = unit(random);
            scales[k] = glm::vec4(scale, scale, 0.02f, 0.0f);
            offsets[k] = glm::vec4(24.0f + 16.0f * dx, 24.0f + 16.0f * dy, 0.5f, 0.0f);
        }
        const float x = unit(random), y = unit(random), z = unit(random);
        const glm::vec3 light = (glm::vec3(x, y, z) - 0.5f) * 50.0f;
        const glm::vec4 found = cascade_by_projection(light, scales, offsets, size, 1.5f);
        const auto number = static_cast<glm::length_t>(found.w);
        ++seen[number];
        for (glm::length_t k = 0; k < number; ++k)
            CHECK(!inside_cascade(cascade_coordinate(light, scales[k], offsets[k]), size, 1.5f));
        if (number == 4) continue;
        CHECK(glm::vec3(found) == cascade_coordinate(light, scales[number], offsets[number]));
        CHECK(inside_cascade(glm::vec3(found), size, 1.5f));
    }
    for (const int count : seen) CHECK(count > 20);
}

TEST_CASE("cascade_by_projection: a NaN is in none, and what is in none is lit") {
    const image<float> dark({4, 4}, 0.0f);
    const glm::vec4 found =
        cascade_by_projection(glm::vec3(std::nanf("")), glm::mat4(1.0f), glm::mat4(1.0f), glm::vec2(64.0f), 0.0f);
    CHECK(found.w == 4.0f);
    CHECK(hard(clamped(dark), glm::vec2(found), found.z) == 1.0f);
}

TEST_CASE("cascade_column_8: the column of that number") {
    glm::mat4 m[2];
    for (int i = 0; i < 8; ++i) m[i / 4][i % 4] = glm::vec4(static_cast<float>(i), 7.0f, 8.0f, 9.0f);
    for (float number = 0; number < 8; ++number) CHECK(cascade_column_8(m[0], m[1], number).x == number);
    CHECK(cascade_column_8(m[0], m[1], 8.0f).x == 7.0f);
}

TEST_CASE("cascade_by_projection_8: the first of eight that holds a point, as each by itself") {
    const glm::vec2 size(64, 48);
    glm::mat4 scales[2]{glm::mat4(0), glm::mat4(0)}, offsets[2]{glm::mat4(0), glm::mat4(0)};
    for (int k = 0; k < 8; ++k) {
        const float scale = 16.0f / static_cast<float>(1 << k);
        scales[k / 4][k % 4] = glm::vec4(scale, scale, 0.02f, 0.0f);
        offsets[k / 4][k % 4] = glm::vec4(32.0f, 24.0f, 0.5f, 0.0f);
    }
    int seen[9]{};
    for (float x = -200; x < 200; x += 0.75f) {
        const glm::vec3 light(x, x * 0.25f, 1);
        const glm::vec4 found =
            cascade_by_projection_8(light, scales[0], offsets[0], scales[1], offsets[1], size, 1.5f);
        int number = 0;
        for (; number < 8; ++number)
            if (inside_cascade(
                    cascade_coordinate(light, scales[number / 4][number % 4], offsets[number / 4][number % 4]), size,
                    1.5f))
                break;
        CHECK(found.w == static_cast<float>(number));
        ++seen[number];
        if (number < 8)
            CHECK(glm::vec3(found) ==
                  cascade_coordinate(light, scales[number / 4][number % 4], offsets[number / 4][number % 4]));
    }
    CHECK(seen[7] > 0);
    const glm::vec4 none =
        cascade_by_projection_8(glm::vec3(1e9f), scales[0], offsets[0], scales[1], offsets[1], size, 1.5f);
    CHECK(none == glm::vec4(65536, 65536, 0, 8));
}

TEST_CASE("cascade_tile: tiles, two in a row") {
    CHECK(cascade_tile(0, {16, 8}) == glm::ivec2(0, 0));
    CHECK(cascade_tile(1, {16, 8}) == glm::ivec2(16, 0));
    CHECK(cascade_tile(2, {16, 8}) == glm::ivec2(0, 8));
    CHECK(cascade_tile(3, {16, 8}) == glm::ivec2(16, 8));
    CHECK(cascade_tile(7, {16, 8}) == glm::ivec2(16, 24));
}
