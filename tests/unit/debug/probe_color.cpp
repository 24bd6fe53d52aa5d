// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include <umbrage/debug/probe_color.hpp>

using namespace umbrage;

namespace {

constexpr glm::dvec3 magenta(1, 0, 1), black(0, 0, 0), white(1, 1, 1), cyan(0, 1, 1), blue(0, 0, 1), red(1, 0, 0),
    yellow(1, 1, 0);

template <class T>
glm::dvec3 probed(T x, T y, T z, T bias = T(0.001), T number = T(0), depth_direction d = depth_direction::forward) {
    return glm::dvec3(probe_color(glm::vec<3, T>(x, y, z), glm::vec<2, T>(8, 4), bias, number, d));
}

}  // namespace

TEST_CASE_TEMPLATE("probe_color: a color for each reason why a receiver cannot be shadowed", T, float, double) {
    constexpr T nan = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity();
    for (const T wrong : {nan, infinite, -infinite, T(0x1p64), T(-0x1p64)}) {
        CHECK(probed<T>(wrong, T(1), T(0.5)) == magenta);
        CHECK(probed<T>(T(1), wrong, T(0.5)) == magenta);
        CHECK(probed<T>(T(1), T(1), wrong) == magenta);
    }
    CHECK(probed<T>(T(65536), T(65536), T(0)) == black);
    CHECK(probed<T>(T(65535), T(1), T(0.5)) == white);
    for (const glm::vec<2, T> at : {glm::vec<2, T>(-0.5, 2), {8.5, 2}, {4, -0.5}, {4, 4.5}})
        CHECK(probed<T>(at.x, at.y, T(0.5)) == white);
    CHECK(probed<T>(T(4), T(2), T(1.5)) == cyan);
    CHECK(probed<T>(T(4), T(2), T(-0.5)) == blue);
    CHECK(probed<T>(T(4), T(2), T(1.5), T(0), T(0), depth_direction::reversed) == blue);
    CHECK(probed<T>(T(4), T(2), T(-0.5), T(0), T(0), depth_direction::reversed) == cyan);
    for (const T bias : {T(1), T(2), nan, infinite}) CHECK(probed<T>(T(4), T(2), T(0.5), bias) == red);
}

TEST_CASE_TEMPLATE("probe_color: borders and planes still belong to the map", T, float, double) {
    for (const auto d : {depth_direction::forward, depth_direction::reversed})
        for (const T z : {T(0), T(1)}) CHECK(probed<T>(T(4), T(2), z, T(0), T(0), d) == probed<T>(T(4), T(2), T(0.5)));
    CHECK(probed<T>(T(0), T(0), T(0.5)) == probed<T>(T(0.5), T(0.5), T(0.5)));
    CHECK(probed<T>(T(8), T(4), T(0.5)) == probed<T>(T(0.5), T(0.5), T(0.5)));  // an even square
}

TEST_CASE_TEMPLATE("probe_color: squares of one texel, and eight colors of maps", T, float, double) {
    const auto even = probed<T>(T(2.25), T(1.75), T(0.5)), odd = probed<T>(T(3.25), T(1.75), T(0.5));
    CHECK(probed<T>(T(2.75), T(1.25), T(0.5)) == probed<T>(T(3.5), T(0.5), T(0.5)));
    CHECK(odd != probed<T>(T(3.5), T(0.5), T(0.5)));
    CHECK(even == odd * 0.75);
    CHECK(odd == glm::dvec3(0.375, 0.375, 0.375));
    std::set<std::tuple<double, double, double>> colors;
    for (int number = 0; number < 8; ++number) {
        const auto c = probed<T>(T(3.25), T(1.75), T(0.5), T(0), T(number));
        colors.insert({c.x, c.y, c.z});
        CHECK(probed<T>(T(3.25), T(1.75), T(0.5), T(0), T(number + 8)) == c);
    }
    CHECK(colors.size() == 8);
    for (const auto& known : {magenta, black, white, cyan, blue, red, yellow})
        CHECK(colors.count({known.x, known.y, known.z}) == 0);
}

TEST_CASE_TEMPLATE("probe_inputs: positions and normals that are no numbers, and a normal of zero", T, float, double) {
    const glm::vec<3, T> color(T(0.25), T(0.5), T(0.75)), world(1, 2, 3), normal(0, 1, 0);
    CHECK(probe_inputs(color, world, normal) == color);
    CHECK(glm::dvec3(probe_inputs(color, world, glm::vec<3, T>(0))) == yellow);
    for (const T wrong : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), T(-0x1p64)})
        for (glm::length_t i = 0; i < 3; ++i) {
            glm::vec<3, T> bad = world, bad_normal(0);
            bad[i] = bad_normal[i] = wrong;
            CHECK(glm::dvec3(probe_inputs(color, bad, normal)) == magenta);
            CHECK(glm::dvec3(probe_inputs(color, world, bad_normal)) == magenta);
        }
}
