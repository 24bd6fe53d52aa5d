// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <umbrage/debug/false_color.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("false_color: the colors on the way, by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    CHECK(false_color(T(0)) == vec(0, 0, 0.5));    // dark blue
    CHECK(false_color(T(0.125)) == vec(0, 0, 1));  // blue
    CHECK(false_color(T(0.25)) == vec(0, 0.5, 1));
    CHECK(false_color(T(0.375)) == vec(0, 1, 1));    // cyan
    CHECK(false_color(T(0.5)) == vec(0.5, 1, 0.5));  // green
    CHECK(false_color(T(0.625)) == vec(1, 1, 0));    // yellow
    CHECK(false_color(T(0.75)) == vec(1, 0.5, 0));
    CHECK(false_color(T(0.875)) == vec(1, 0, 0));  // red
    CHECK(false_color(T(1)) == vec(0.5, 0, 0));    // dark red
}

TEST_CASE_TEMPLATE("false_color: clamped, NaN as the far end", T, float, double) {
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (T below : {T(-0.0), T(-1e-30), T(-1), -infinity}) CHECK(false_color(below) == false_color(T(0)));
    for (T above : {T(1.001), T(1e30), infinity, nan, -nan}) CHECK(false_color(above) == false_color(T(1)));
}

TEST_CASE("false_color: no jumps, hue falls from blue to red, the two ends mirror each other") {
    constexpr int steps = 1 << 16;
    double hue_before = 240, greatest_step = 0;
    glm::vec3 before = false_color(0.0f);
    int wrong = 0;
    for (int i = 0; i <= steps; ++i) {
        const float v = static_cast<float>(i) / steps;
        const glm::vec3 c = false_color(v);
        for (int k = 0; k < 3; ++k) {
            wrong += !(c[k] >= 0 && c[k] <= 1);
            greatest_step = std::max(greatest_step, double(std::abs(c[k] - before[k])));
        }
        // hue in degrees
        const double high = std::max({c.x, c.y, c.z}), low = std::min({c.x, c.y, c.z}), range = high - low;
        const double hue = c.z == high && c.x <= c.y && c.y < c.z ? 240 - 60 * (double(c.y) - low) / range
                           : c.y == high                          ? 120 + 60 * (double(c.z) - double(c.x)) / range
                                                                  : 60 * (double(c.y) - low) / range;
        wrong += !(hue <= hue_before + 1e-4);
        hue_before = hue;
        before = c;
        const glm::vec3 mirrored = false_color(1.0f - v);
        wrong += c != glm::vec3(mirrored.z, mirrored.y, mirrored.x);
    }
    CHECK(wrong == 0);
    CHECK(hue_before == 0);
    CHECK(greatest_step <= 4.0 / steps + 1e-7);
}
