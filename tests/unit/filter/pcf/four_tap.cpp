// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../maps.hpp"

using namespace umbrage;

TEST_CASE("four_tap: each tap counts a quarter, whatever its place in the order") {
    for (int mask = 0; mask < 16; ++mask) {
        const auto fetch = [&](glm::ivec2 t) { return mask >> t.x & 1 ? 1.0f : 0.0f; };
        const glm::vec2 a(0.5f), b(1.5f, 0), c(2.5f, -7), d(3.5f, 9);
        const float quarter = four_tap(fetch, a, b, c, d, 0.5f) * 4;
        CHECK(quarter == static_cast<float>((mask & 1) + (mask >> 1 & 1) + (mask >> 2 & 1) + (mask >> 3)));
        CHECK(four_tap(fetch, d, a, c, b, 0.5f) * 4 == quarter);
        CHECK(four_tap(fetch, glm::dvec2(a), glm::dvec2(b), glm::dvec2(c), glm::dvec2(d), 0.5) * 4 == double(quarter));
    }
}

TEST_CASE("four_tap: lit where the mean of the taps is outside texel space, or a coordinate NaN") {
    const auto dark = [](glm::ivec2) { return 0.0f; };
    const glm::vec2 in(1), zero(0);
    for (glm::vec2 out : coordinates_outside_texel_space()) CHECK(four_tap(dark, out, out, out, out, 0.5f) == 1.0f);
    const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    for (float bad : {131072.0f, -131072.0f, 1e30f, -1e30f, infinity, -infinity, nan, -nan})
        for (glm::vec2 out : {glm::vec2(bad, 1), glm::vec2(1, bad), glm::vec2(bad, -bad)}) {
            CHECK(four_tap(dark, out, in, in, in, 0.5f) == 1.0f);
            CHECK(four_tap(dark, in, out, in, out, 0.5f) == 1.0f);
            CHECK(four_tap(dark, in, in, in, glm::vec2(out), 0.5f) == 1.0f);
        }
    const glm::vec2 corner(32767.5f, -32766.5f), far(131071.5f, 0), beyond(-131071.5f, 0);
    CHECK(four_tap(dark, corner, corner, corner, corner, 0.5f) == 0.0f);
    CHECK(four_tap(dark, zero, far, zero, zero, 0.5f) == 0.0f);
    CHECK(four_tap(dark, zero, beyond, zero, zero, 0.5f) == 1.0f);
    CHECK(four_tap(dark, in, in, in, in, nan) == 0);
    CHECK(four_tap(dark, in, in, in, in, 1.5f) == 1);
}

TEST_CASE("four_tap: with the default taps it is pcf_2x2 at texel corners") {
    std::mt19937 random(3);
    const glm::ivec2 size(12, 9);
    const image<float> map = random_map(random, size);
    const auto& taps = default_taps<float>;
    int partly = 0;
    for (int y = -2; y <= size.y + 2; ++y)
        for (int x = -2; x <= size.x + 2; ++x)
            for (float receiver : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f, 2.0f}) {
                const glm::vec2 corner(x, y);
                const float got = four_tap(clamped(map), corner + taps[0], corner + taps[1], corner + taps[2],
                                           corner + taps[3], receiver);
                CHECK(got == pcf_2x2(clamped(map), corner, receiver));
                partly += got > 0 && got < 1;
            }
    CHECK(partly > 100);
}

TEST_CASE("four_tap: brute force") {
    std::mt19937 random(4);
    const glm::ivec2 size(6, 5);
    const image<float> map = random_map(random, size);
    std::uniform_real_distribution<float> coordinate(-3, 9);
    for (int i = 0; i < 5000; ++i) {
        glm::vec2 tap[4];
        int lit = 0;
        const float receiver = static_cast<float>(i % 9) / 8.0f;
        for (auto& t : tap) {
            t = {coordinate(random), coordinate(random)};
            lit +=
                texel_at(map, std::llround(std::floor(double(t.x))), std::llround(std::floor(double(t.y)))) >= receiver;
        }
        CHECK(four_tap(clamped(map), tap[0], tap[1], tap[2], tap[3], receiver) == static_cast<float>(lit) / 4);
    }
}
