// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/cascades/blend.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace umbrage;

TEST_CASE_TEMPLATE("cascade_weight: steps of 1/256, and the ends for what is beyond", T, float, double) {
    const T infinity = std::numeric_limits<T>::infinity();
    for (int i = 0; i <= 256; ++i) CHECK(cascade_weight(T(i) / T(256)) == T(i) / T(256));
    CHECK(cascade_weight(T(0.999)) == T(255) / T(256));
    CHECK(cascade_weight(T(0.0039)) == T(0));
    for (const T v : {T(-0.5), T(0), -infinity, std::numeric_limits<T>::quiet_NaN()}) CHECK(cascade_weight(v) == T(0));
    for (const T v : {T(1), T(7), infinity}) CHECK(cascade_weight(v) == T(1));
}

TEST_CASE_TEMPLATE("cascade_fade: grows over the last tenth of a cascade", T, float, double) {
    // from 20 to 30 over the last metre
    const auto weight = [](double depth) { return cascade_fade(T(depth), T(1), T(-29)); };
    CHECK(weight(20) == T(0));
    CHECK(weight(29) == T(0));
    CHECK(weight(29.5) == T(0.5));
    CHECK(weight(29.75) == T(0.75));
    CHECK(weight(30) == T(1));
    CHECK(weight(40) == T(1));
}

TEST_CASE_TEMPLATE("cascade_border_fade: 1 where the filter reaches the border, 0 a band further in", T, float,
                   double) {
    const auto weight = [](double x, double y) {
        return cascade_border_fade(glm::vec<2, T>(T(x), T(y)), glm::vec<2, T>(T(128), T(64)), T(2), T(0.125));
    };
    CHECK(weight(64, 32) == T(0));
    for (const double d : {0.0, 1.0, 2.0, 3.0, 6.0, 9.0, 10.0, 12.0}) {
        const T expected = T(std::clamp((10 - d) / 8, 0.0, 1.0));
        CHECK(weight(d, 32) == expected);
        CHECK(weight(128 - d, 32) == expected);
        CHECK(weight(64, d) == expected);
        CHECK(weight(64, 64 - d) == expected);
    }
    CHECK(weight(3, 6) == T(0.875));
    CHECK(weight(std::nan(""), 6) == T(0.5));
}

TEST_CASE_TEMPLATE("blend_cascades: nothing rounds for visibilities of pcf_2x2", T, float, double) {
    for (int w = 0; w <= 256; ++w)
        for (int i = 0; i < 300; ++i) {
            const int a = i * 7919 % 65537, b = i * 104729 % 65537;
            const double exact = (double(a) * (256 - w) + double(b) * w) / 16777216.0;
            CHECK(double(blend_cascades(T(a) / T(65536), T(b) / T(65536), T(w) / T(256))) == exact);
        }
    CHECK(blend_cascades(T(1) / T(3), T(1) / T(7), T(0)) == T(1) / T(3));
    CHECK(blend_cascades(T(1) / T(3), T(1) / T(7), T(1)) == T(1) / T(7));
}

TEST_CASE("dither_threshold: Bayer's matrix in every 4 x 4 pixels, the first threshold where there are no pixels") {
    constexpr int bayer[4][4]{{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    for (int y = -9; y < 9; ++y)
        for (int x = -9; x < 9; ++x) {
            const float m = static_cast<float>(bayer[y & 3][x & 3]);
            CHECK(dither_threshold(glm::vec2(x, y)) == (m + 0.5f) / 16.0f);
            CHECK(dither_threshold(glm::vec2(x, y) + 0.5f) == (m + 0.5f) / 16.0f);
        }
    CHECK(dither_threshold(glm::vec2(40000.0f, 1.0f)) == 1.0f / 32.0f);
    CHECK(dither_threshold(glm::vec2(1.0f, std::nanf(""))) == 1.0f / 32.0f);
}

TEST_CASE("dithered_cascade: over 4 x 4 pixels a weight's share of them, to 1/32, takes the next one") {
    for (int w = 0; w <= 256; ++w) {
        const float weight = static_cast<float>(w) / 256.0f;
        float sum = 0.0f;
        for (int i = 0; i < 16; ++i)
            sum += dithered_cascade(2.0f, weight, dither_threshold(glm::vec2(i % 4, i / 4))) - 2.0f;
        CHECK(std::abs(sum / 16.0f - weight) <= 1.0f / 32.0f);
    }
}
