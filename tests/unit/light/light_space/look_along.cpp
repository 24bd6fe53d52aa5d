// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/light/light_space.hpp>

#include "../../special_values.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

/// Evenly over the sphere, then closer and closer to both poles, then the axes and diagonals.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> all;
    constexpr int count = 2000;
    for (int i = 0; i < count; ++i) {
        const double y = 1.0 - (2 * i + 1.0) / count, r = std::sqrt(1.0 - y * y), turn = i * 2.399963229728653;
        all.push_back({r * std::cos(turn), y, r * std::sin(turn)});
    }
    for (double tilt = 1.0; tilt > 1e-12; tilt *= 0.7)
        for (double sign : {-1.0, 1.0})
            for (double turn : {0.0, 1.0, 2.5, 4.0})
                all.push_back({tilt * std::cos(turn), sign, tilt * std::sin(turn)});
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) all.push_back({x, y, z});
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE("look_along: a rotation whichever hand, down the axis of that hand, for every direction and up", T,
                   float, double) {
    using vec = glm::vec<3, T>;
    const double eps = std::numeric_limits<T>::epsilon();
    for (auto hand : {handedness::right, handedness::left})
        for (vec up : {vec(0, 1, 0), vec(0, 0, 1), vec(1, 2, 3), vec(0, -1, 0), vec(0, 0, 0)}) {
            double worst = 0, worst_axis = 0, worst_hand = 0;
            auto all = directions();
            for (glm::dvec3 d : directions()) all.push_back(glm::dvec3(up) + d * 0.01);  // nearly parallel to up
            for (glm::dvec3 d : all) {
                const vec direction(d);
                const glm::dmat3 view(look_along(vec(0), direction, up, hand));
                const glm::dmat3 unit = view * glm::transpose(view);
                for (int c = 0; c < 3; ++c)
                    for (int r = 0; r < 3; ++r) worst = worse(worst, std::abs(unit[c][r] - (c == r)));
                const double depth = hand == handedness::right ? -1.0 : 1.0;
                const glm::dvec3 axis = view * glm::normalize(glm::dvec3(direction));
                worst_axis = worse(worst_axis, glm::length(axis - glm::dvec3(0, 0, depth)));
                worst_hand = worse(worst_hand, std::abs(glm::determinant(view) - 1));
            }
            CAPTURE(int(hand));
            CAPTURE(up.x);
            CAPTURE(up.y);
            CHECK(worst < 6 * eps);
            CHECK(worst_axis < 4 * eps);
            CHECK(worst_hand < 8 * eps);
        }
}

TEST_CASE_TEMPLATE("look_along: glm::lookAtRH and lookAtLH, to a few ulp", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec up(T(0.2), 1, T(0.1));
    double rotation = 0, translation = 0;
    for (glm::dvec3 direction : directions()) {
        const vec d(glm::normalize(direction)), away = d * T(4), position(3, -2, 5);
        if (glm::length(glm::cross(d, glm::normalize(up))) < T(0.1)) continue;
        // from the origin the target is exact; from elsewhere it is rounded, by an ulp of the position over 4
        rotation =
            worse(rotation, difference(look_along(vec(0), d, up, handedness::right), glm::lookAtRH(vec(0), d, up)));
        rotation =
            worse(rotation, difference(look_along(vec(0), d, up, handedness::left), glm::lookAtLH(vec(0), d, up)));
        translation = worse(translation, difference(look_along(position, away, up, handedness::right),
                                                    glm::lookAtRH(position, position + away, up)));
        translation = worse(translation, difference(look_along(position, away, up, handedness::left),
                                                    glm::lookAtLH(position, position + away, up)));
    }
    CHECK(rotation < 4 * double(std::numeric_limits<T>::epsilon()));
    CHECK(translation < 8 * double(std::numeric_limits<T>::epsilon()));
}

TEST_CASE("look_along: a hand-made case, up stays up, the length of the direction does not matter") {
    const glm::dmat4 view =
        look_along(glm::dvec3(1, 2, 3), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), handedness::right);
    // looking along +x with y up, +z is to the right
    CHECK(glm::dvec3(view * glm::dvec4(1, 2, 3, 1)) == glm::dvec3(0, 0, 0));
    CHECK(glm::dvec3(view * glm::dvec4(5, 3, 7, 1)) == glm::dvec3(4, 1, -4));
    // in a left-handed world -z is
    const glm::dmat4 left = look_along(glm::dvec3(1, 2, 3), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), handedness::left);
    CHECK(glm::dvec3(left * glm::dvec4(5, 3, 7, 1)) == glm::dvec3(-4, 1, 4));

    for (auto hand : {handedness::right, handedness::left})
        for (glm::vec3 d : {glm::vec3(0.3f, -1, 0.2f), glm::vec3(0, -1, 0), glm::vec3(0, 3, 0)}) {
            const glm::mat4 middle = look_along(glm::vec3(0), d, glm::vec3(0, 1, 0), hand);
            for (int power : {-120, -60, 60, 120})
                CHECK(look_along(glm::vec3(0), d * std::ldexp(1.0f, power), glm::vec3(0, 1, 0), hand) == middle);
            for (float length : {1e-38f, 1e-30f, 1e-10f, 1e10f, 1e30f, 1e38f})
                CHECK(difference(look_along(glm::vec3(0), d, glm::vec3(0, length, 0), hand), middle) < 1e-6);
        }
}

TEST_CASE_TEMPLATE("look_along: up counts from an angle of 1e-3 on, below that a world axis takes its place", T, float,
                   double) {
    using vec = glm::vec<3, T>;
    const auto side = [](T tilt) {
        const auto view = look_along(vec(0), vec(tilt, -1, 0), vec(0, 1, 0), handedness::right);
        return vec(view[0][0], view[1][0], view[2][0]);
    };
    CHECK(glm::length(side(T(0.0011)) - vec(0, 0, 1)) < 1e-3);
    CHECK(glm::length(side(T(-0.0011)) - vec(0, 0, -1)) < 1e-3);
    for (T tilt : {T(0.0009), T(-0.0009)}) CHECK(glm::length(side(tilt) - vec(-1, 0, 0)) < 1e-3);
}

TEST_CASE_TEMPLATE("look_along: bad input", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec zero(0), down(0, -1, 0), up(0, 1, 0);
    CHECK_THROWS_AS((void)look_along(zero, zero, up, handedness::right), std::invalid_argument);
    for (double bad : {nan64, -nan64, inf64, -inf64})
        for (int i = 0; i < 3; ++i) {
            vec v(1);
            v[i] = T(bad);
            CHECK_THROWS_AS((void)look_along(v, down, up, handedness::right), std::invalid_argument);
            CHECK_THROWS_AS((void)look_along(zero, v, up, handedness::left), std::invalid_argument);
            CHECK_THROWS_AS((void)look_along(zero, down, v, handedness::left), std::invalid_argument);
        }
    CHECK_NOTHROW((void)look_along(zero, down, zero, handedness::right));
}

TEST_CASE("look_along: errors name the function and the argument") {
    const float greatest = std::numeric_limits<float>::max();
    const auto look = [](glm::vec3 position, glm::vec3 direction, glm::vec3 up) {
        return complaint([=] { (void)look_along(position, direction, up, handedness::left); });
    };
    const glm::vec3 down(0, -1, 0), far_out(greatest);
    CHECK(look(far_out, {1, 1, 1}, down).starts_with("umbrage::look_along: position "));
    CHECK(look({0, inf64, 0}, down, down).starts_with("umbrage::look_along: position "));
    CHECK(look({}, {}, down).starts_with("umbrage::look_along: direction "));
    CHECK(look({}, {0, inf64, 0}, down).starts_with("umbrage::look_along: direction "));
    CHECK(look({}, down, {inf64, 0, 0}).starts_with("umbrage::look_along: up "));
}
