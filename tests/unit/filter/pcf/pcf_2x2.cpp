// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>

#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "../maps.hpp"

using namespace umbrage;

namespace {

/// The four texels at (base + 0..1) lit as `mask` says; NaN, in shadow, elsewhere, where nobody may look.
auto masked(int mask, glm::ivec2 base) {
    return [=](glm::ivec2 t) {
        const glm::ivec2 k = t - base;
        if (k.x < 0 || k.x > 1 || k.y < 0 || k.y > 1) return std::numeric_limits<float>::quiet_NaN();
        return mask >> (k.x + 2 * k.y) & 1 ? 1.0f : 0.0f;
    };
}

/// Weights in integers of 2^-16.
int weighted(int mask, int fx, int fy) {
    const int weights[4] = {(256 - fx) * (256 - fy), fx * (256 - fy), (256 - fx) * fy, fx * fy};
    int sum = 0;
    for (int k = 0; k < 4; ++k) sum += mask >> k & 1 ? weights[k] : 0;
    return sum;
}

}  // namespace

TEST_CASE("pcf_2x2: every mask and every pair of weights against whole numbers") {
    int wrong = 0;
    for (int mask = 0; mask < 16; ++mask)
        for (int fy = 0; fy < 256; ++fy)
            for (int fx = 0; fx < 256; ++fx) {
                // anywhere within the 1/256 that the weights stand for
                const glm::ivec2 base(fy % 7 - 3, fx % 5 * 1000 - 2000);
                const glm::vec2 part(static_cast<float>((fx * 31 + fy) % 8) / 8,
                                     static_cast<float>((fx + fy * 31) % 8) / 8);
                const glm::vec2 coord = glm::vec2(base) + 0.5f + (glm::vec2(fx, fy) + part) / 256.0f;
                wrong +=
                    pcf_2x2(masked(mask, base), coord, 0.5f) * 65536.0f != static_cast<float>(weighted(mask, fx, fy));
            }
    CHECK(wrong == 0);
}

TEST_CASE_TEMPLATE("pcf_2x2: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    image<T> map({2, 2});
    map[{0, 0}] = 0, map[{1, 0}] = 1, map[{0, 1}] = T(0.5), map[{1, 1}] = 0;
    const auto at = [&](T x, T y, T receiver) { return pcf_2x2(clamped(map), vec(x, y), receiver); };
    CHECK(at(0.5, 0.5, T(0.1)) == 0);  // a texel's center is that texel alone
    CHECK(at(1.5, 0.5, T(0.1)) == 1);
    CHECK(at(1, 0.5, T(0.1)) == 0.5);
    CHECK(at(1, 1, T(0.5)) == 0.5);  // a tie is lit
    CHECK(at(1, 1, T(0.6)) == 0.25);
    CHECK(at(0.75, 0.625, T(0.5)) == T(0.25 * 0.875 + 0.75 * 0.125));
    CHECK(at(-5, 1.5, T(0.5)) == 1);  // left of the map counts as its first column
    CHECK(at(1, 1, std::numeric_limits<T>::quiet_NaN()) == 0);
    CHECK(pcf_2x2(bordered(map, T(1)), vec(0, 0.5), T(0.1)) == 0.5);
    CHECK(pcf_2x2(bordered(map, T(0)), vec(2, 0.5), T(0.1)) == 0.5);
}

TEST_CASE("pcf_2x2: brute force, in float and double, up to the limits of texel space") {
    std::mt19937 random(5);
    const glm::ivec2 size(4, 3);
    const image<float> map = random_map(random, size, 2);
    const auto fetch = clamped(map);
    int wrong = 0, partly = 0, tried = 0;
    for (float x : awkward_coordinates(random, size.x))
        for (float y : awkward_coordinates(random, size.y)) {
            const float receiver = static_cast<float>(tried++ % 3) / 2.0f;
            // position in 1/256 texel, in integers from here on
            const long long px = std::llround(std::floor(double(x) * 256.0)) - 128,
                            py = std::llround(std::floor(double(y) * 256.0)) - 128;
            const long long tx = px >> 8, ty = py >> 8;
            int mask = 0;
            for (int k = 0; k < 4; ++k) mask |= (texel_at(map, tx + k % 2, ty + k / 2) >= receiver) << k;
            const int expected = weighted(mask, static_cast<int>(px & 255), static_cast<int>(py & 255));
            const float got = pcf_2x2(fetch, glm::vec2(x, y), receiver);
            wrong += got * 65536.0f != static_cast<float>(expected);
            wrong += pcf_2x2(fetch, glm::dvec2(x, y), double(receiver)) != double(got);
            partly += got > 0 && got < 1;
        }
    CHECK(wrong == 0);
    CHECK(partly > 5000);
}

TEST_CASE("pcf_2x2: moving map and receiver together changes nothing, mirroring both neither") {
    std::mt19937 random(6);
    const image<float> map = random_map(random, {16, 16});
    std::uniform_int_distribution<int> position(-512, 17 * 256), shift(-30000, 30000);
    for (int i = 0; i < 3000; ++i) {
        const glm::vec2 coord = glm::vec2(position(random), position(random)) / 256.0f;
        const float receiver = static_cast<float>(i % 9) / 8.0f;
        const float here = pcf_2x2(clamped(map), coord, receiver);
        const glm::ivec2 by(shift(random), shift(random));
        const auto moved = [&](glm::ivec2 t) { return fetch_clamped(map.view(), t - by); };
        CHECK(pcf_2x2(moved, coord + glm::vec2(by), receiver) == here);
        const auto mirrored = [&](glm::ivec2 t) { return fetch_clamped(map.view(), {-1 - t.x, t.y}); };
        CHECK(pcf_2x2(mirrored, glm::vec2(-coord.x, coord.y), receiver) == here);
        const auto turned = [&](glm::ivec2 t) { return fetch_clamped(map.view(), {t.y, t.x}); };
        CHECK(pcf_2x2(turned, glm::vec2(coord.y, coord.x), receiver) == here);
    }
}

TEST_CASE_TEMPLATE("pcf_2x2_dx_sdk: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    image<T> map({2, 2});
    map[{0, 0}] = 0, map[{1, 0}] = 1, map[{0, 1}] = T(0.5), map[{1, 1}] = 0;
    const auto at = [&](T x, T y, T receiver, T epsilon) {
        return pcf_2x2_dx_sdk(clamped(map), vec(x, y), receiver, epsilon);
    };
    CHECK(at(0.5, 0.5, T(0.1), 0) == 0);
    CHECK(at(1.5, 0.5, T(0.1), 0) == 1);
    CHECK(at(1, 1, T(0.625), 0) == 0.25);
    CHECK(at(1, 1, T(0.625), T(0.125)) == 0.5);  // 0.5 + 0.125 < 0.625 does not hold: lit
    CHECK(at(1, 1, T(0.625), T(0.0625)) == 0.25);
    CHECK(at(0.75, 0.625, T(0.5), 0) == T(0.25 * 0.875 + 0.75 * 0.125));
    CHECK(at(1, 1, std::numeric_limits<T>::quiet_NaN(), 0) == 1);  // as compare_dx_sdk has it
}

TEST_CASE("pcf_2x2_dx_sdk: pcf_2x2 where the weights are whole 1/256, within 1/128 of it everywhere") {
    std::mt19937 random(7);
    const image<float> map = random_map(random, {16, 16}, 2);
    const auto fetch = clamped(map);
    std::uniform_int_distribution<int> position(-512, 18 * 256);
    std::uniform_real_distribution<float> coordinate(-2, 18);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const float receiver = static_cast<float>(i % 4) / 3.0f;
        const glm::vec2 grid = glm::vec2(position(random), position(random)) / 256.0f;
        if (i < 20000) CHECK(pcf_2x2_dx_sdk(fetch, grid, receiver, 0.0f) == pcf_2x2(fetch, grid, receiver));
        const glm::vec2 c(coordinate(random), coordinate(random));
        worst =
            std::max(worst, double(std::abs(pcf_2x2_dx_sdk(fetch, c, receiver, 0.0f) - pcf_2x2(fetch, c, receiver))));
    }
    // each of the two weights is cut by less than 1/256
    CHECK(worst < 1.0 / 128);
    CHECK(worst > 1.0 / 256);
}

TEST_CASE("pcf_2x2_dx_sdk: against double") {
    std::mt19937 random(8);
    const image<float> map = random_map(random, {8, 8});
    std::uniform_real_distribution<float> coordinate(-2, 10), step(0, 1);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 c(coordinate(random), coordinate(random));
        const float receiver = step(random), epsilon = step(random) * 0.1f;
        const long long x = std::llround(std::floor(c.x - 0.5)), y = std::llround(std::floor(c.y - 0.5));
        const double u = c.x - 0.5 - double(x), v = c.y - 0.5 - double(y);
        double expected = 0;
        for (int k = 0; k < 4; ++k)
            expected += float(texel_at(map, x + k % 2, y + k / 2)) + epsilon < receiver
                            ? 0
                            : (k % 2 ? u : 1 - u) * (k / 2 ? v : 1 - v);
        const float got = pcf_2x2_dx_sdk(clamped(map), glm::vec2(c), receiver, epsilon);
        worst = std::max(worst, std::abs(double(got) - expected));
        CHECK_FALSE(!(got >= 0.0f && got <= 1.0f));
    }
    CHECK(worst < 3e-7);
}

TEST_CASE("pcf_2x2, pcf_2x2_dx_sdk: all lit is exactly 1, all dark exactly 0, in every place") {
    std::mt19937 random(9);
    for (float x : awkward_coordinates(random, 2))
        for (float y : {0.1f, -7.77f, 1234.567f}) {
            const glm::vec2 c(x, y);
            const auto fetch = [](glm::ivec2) { return 0.5f; };
            CHECK(pcf_2x2(fetch, c, 0.5f) == 1.0f);
            CHECK(pcf_2x2(fetch, c, 0.6f) == 0.0f);
            CHECK(pcf_2x2_dx_sdk(fetch, c, 0.5f, 0.0f) == 1.0f);
            CHECK(pcf_2x2_dx_sdk(fetch, c, 0.6f, 0.0f) == 0.0f);
        }
}
