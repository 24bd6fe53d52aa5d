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

TEST_CASE("perspective: z/w of a hand-made case in every convention") {
    // between 1 and 3, z/w = 1.5 - 1.5 / distance: 0.75 at distance 2
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dmat4 m = perspective(2.0, 4.0, 1.0, 3.0, clip);
        const double front = clip.hand == handedness::right ? -1 : 1;
        const bool reversed = clip.direction == depth_direction::reversed, zo = clip.range == depth_range::zero_to_one;
        const double middle = reversed ? 0.25 : 0.75;
        const auto depth = [&](double share) { return zo ? share : 2 * share - 1; };
        const glm::dvec3 p = through(m, {3, 2, 2 * front});
        CHECK(p.x == doctest::Approx(0.75));
        CHECK(p.y == doctest::Approx(0.25));
        CHECK(p.z == doctest::Approx(depth(middle)));
        CHECK(through(m, {0, 0, front}).z == doctest::Approx(depth(reversed)));
        CHECK(through(m, {0, 0, 3 * front}).z == doctest::Approx(depth(!reversed)));
        CHECK((m * glm::dvec4(0, 0, 2 * front, 1)).w == 2.0);  // w is the distance
    }
}

TEST_CASE_TEMPLATE("perspective, orthographic: GLM's matrices where GLM has one", T, float, double) {
    const double eps = std::numeric_limits<T>::epsilon();
    using vec = glm::vec<2, T>;
    double worst = 0;
    int compared = 0;
    for (T angle : {T(0.01), T(0.3), T(0.8), T(1.5)})
        for (T aspect : {T(0.5), T(1), T(2)})
            for (T z_near : {T(0.01), T(0.5), T(7)})
                for (T z_far : {T(7.5), T(100), T(1e5)})
                    for (clip_space clip : all_clip_spaces()) {
                        if (clip.direction == depth_direction::reversed) continue;
                        const bool right = clip.hand == handedness::right, zo = clip.range == depth_range::zero_to_one;
                        const auto theirs = (right ? (zo ? glm::perspectiveRH_ZO<T> : glm::perspectiveRH_NO<T>)
                                                   : (zo ? glm::perspectiveLH_ZO<T> : glm::perspectiveLH_NO<T>));
                        const T extent = std::tan(angle);
                        worst = worse(worst, difference(perspective(extent * aspect, extent, z_near, z_far, clip),
                                                        theirs(2 * angle, aspect, z_near, z_far)));
                        const auto box = (right ? (zo ? glm::orthoRH_ZO<T> : glm::orthoRH_NO<T>)
                                                : (zo ? glm::orthoLH_ZO<T> : glm::orthoLH_NO<T>));
                        const T low = -extent, high = aspect * 3;
                        worst = worse(worst, difference(orthographic(vec(low, -5), vec(high, 8), z_near, z_far, clip),
                                                        box(low, high, T(-5), T(8), z_near, z_far)));
                        ++compared;
                    }
    CHECK(compared == 4 * 3 * 3 * 3 * 8);
    CHECK(worst < 8 * eps);
}

TEST_CASE("orthographic: corners of the box in every convention, also behind the light") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dmat4 m = orthographic(glm::dvec2(-1, -2), glm::dvec2(3, 6), -4.0, 4.0, clip);
        const double front = clip.hand == handedness::right ? -1 : 1;
        const bool reversed = clip.direction == depth_direction::reversed, zo = clip.range == depth_range::zero_to_one;
        const auto depth = [&](double share) { return zo ? share : 2 * share - 1; };
        const glm::dvec3 first = through(m, {-1, -2, -4 * front}), last = through(m, {3, 6, 4 * front});
        const glm::dvec3 quarter = through(m, {0, 0, -2 * front});
        CHECK(glm::length(first - glm::dvec3(-1, -1, depth(reversed))) < 1e-15);
        CHECK(glm::length(last - glm::dvec3(1, 1, depth(!reversed))) < 1e-15);
        CHECK(glm::length(quarter - glm::dvec3(-0.5, -0.5, depth(reversed ? 0.75 : 0.25))) < 1e-15);
    }
}

TEST_CASE_TEMPLATE("perspective, orthographic: bad input", T, float, double) {
    const auto planes = [](double z_near, double z_far) {
        (void)perspective(T(1), T(1), T(z_near), T(z_far), cpu_clip_space);
    };
    const auto box = [](double low, double high, double z_near, double z_far) {
        (void)orthographic(glm::vec<2, T>(T(-1), T(low)), glm::vec<2, T>(T(1), T(high)), T(z_near), T(z_far),
                           cpu_clip_space);
    };
    CHECK_NOTHROW(planes(1, 2));
    CHECK_NOTHROW(box(-1, 1, -1, 1));
    CHECK_THROWS_AS(planes(2, 2), std::invalid_argument);
    CHECK_THROWS_AS(planes(3, 2), std::invalid_argument);
    CHECK_THROWS_AS(planes(0, 2), std::invalid_argument);
    CHECK_THROWS_AS(planes(-1, 2), std::invalid_argument);
    CHECK_THROWS_AS(box(1, 1, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(box(2, 1, 0, 1), std::invalid_argument);
    CHECK_THROWS_AS(box(0, 1, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(box(0, 1, 2, 1), std::invalid_argument);
    CHECK_NOTHROW(planes(1, inf64));
    CHECK_THROWS_AS(planes(inf64, inf64), std::invalid_argument);
    for (double bad : {nan64, -nan64, inf64, -inf64}) {
        CHECK_THROWS_AS(planes(bad, 2), std::invalid_argument);
        if (bad != inf64) CHECK_THROWS_AS(planes(1, bad), std::invalid_argument);
        CHECK_THROWS_AS(box(bad, 1, 0, 1), std::invalid_argument);
        CHECK_THROWS_AS(box(0, bad, 0, 1), std::invalid_argument);
        CHECK_THROWS_AS(box(0, 1, bad, 1), std::invalid_argument);
        CHECK_THROWS_AS(box(0, 1, 0, bad), std::invalid_argument);
    }
    for (double bad : {nan64, inf64, 0.0, -1.0}) {
        CHECK_THROWS_AS((void)perspective(T(bad), T(1), T(1), T(2), cpu_clip_space), std::invalid_argument);
        CHECK_THROWS_AS((void)perspective(T(1), T(bad), T(1), T(2), cpu_clip_space), std::invalid_argument);
    }
}

TEST_CASE_TEMPLATE("perspective: no far plane, forward and reversed, is what a farther and farther one comes to", T,
                   float, double) {
    const T greatest = std::numeric_limits<T>::max(), no_far = std::numeric_limits<T>::infinity();
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const bool reversed = clip.direction == depth_direction::reversed, zo = clip.range == depth_range::zero_to_one;
        const double front = clip.hand == handedness::right ? -1 : 1;
        const auto m = perspective(T(1), T(1), T(0.5), no_far, clip);
        CHECK(difference(m, perspective(T(1), T(1), T(0.5), greatest, clip)) < 1e-30);
        for (double distance : {0.5, 1.0, 3.0, 1e6}) {
            const double depth = reversed ? 0.5 / distance : 1 - 0.5 / distance;
            CHECK(through(m, {0, 0, front * distance}).z == doctest::Approx(zo ? depth : 2 * depth - 1).epsilon(1e-15));
        }
        const auto far_corner = m * glm::vec<4, T>(0, 0, front, 0);  // a direction: where depth goes
        CHECK(far_corner.z / far_corner.w == (reversed ? (zo ? T(0) : T(-1)) : T(1)));
    }
}

TEST_CASE_TEMPLATE("perspective: depth from plane to plane, however small or large they are", T, float, double) {
    const T least = std::numeric_limits<T>::min(), greatest = std::numeric_limits<T>::max();
    const std::pair<T, T> planes[] = {{T(1e-30), T(1e-20)}, {least, 2 * least},       {least, 1},         {1, greatest},
                                      {least, greatest},    {greatest / 8, greatest}, {T(1e-20), T(1e20)}};
    for (clip_space clip : all_clip_spaces())
        for (const auto& pair : planes) {
            const T z_near = pair.first, z_far = pair.second;  // captured below, which clang 14 refuses of bindings
            CAPTURE(to_string(clip));
            CAPTURE(z_near);
            CAPTURE(z_far);
            const auto m = perspective(T(1), T(1), z_near, z_far, clip);
            CHECK(detail::all_finite(m));
            const bool reversed = clip.direction == depth_direction::reversed;
            const double low = clip.range == depth_range::zero_to_one ? 0 : -1;
            const double front = clip.hand == handedness::right ? -1 : 1, eps = std::numeric_limits<T>::epsilon();
            const auto depth = [&](double distance) {  // z / w, each over the distance lest they overflow
                return (front * double(m[2][2]) + double(m[3][2]) / distance) / (front * double(m[2][3]));
            };
            CHECK(std::abs(depth(z_near) - (reversed ? 1 : low)) <= 4 * eps);
            CHECK(std::abs(depth(z_far) - (reversed ? low : 1)) <= 4 * eps);
        }
}

TEST_CASE("perspective, orthographic: errors name the function and the argument") {
    const float greatest = std::numeric_limits<float>::max(), denormal = 1e-45f;
    const auto persp = [](float x, float y, float z_near, float z_far) {
        return complaint([=] { (void)perspective(x, y, z_near, z_far, cpu_clip_space); });
    };
    CHECK(persp(1, 1, 1, greatest).empty());
    CHECK(persp(0, 1, 1, 2).starts_with("umbrage::perspective: tan_half_x "));
    CHECK(persp(denormal, 1, 1, 2).starts_with("umbrage::perspective: tan_half_x "));  // 1 / it is infinite
    CHECK(persp(1, greatest, 1, 2).starts_with("umbrage::perspective: tan_half_y "));  // 1 / it is a denormal
    CHECK(persp(1, 1, 0, 2).starts_with("umbrage::perspective: z_near "));
    CHECK(persp(1, 1, denormal, 2).starts_with("umbrage::perspective: z_near "));
    CHECK(persp(1, 1, 2, 2).starts_with("umbrage::perspective: z_far "));
    CHECK(persp(1, 1, 3e38f, 3.1e38f).starts_with("umbrage::perspective: z_near and z_far "));  // n f / (f - n)

    const auto ortho = [](float low, float high, float z_near, float z_far) {
        return complaint(
            [=] { (void)orthographic(glm::vec2(-1, low), glm::vec2(1, high), z_near, z_far, cpu_clip_space); });
    };
    CHECK(ortho(-1, 1, -5, 5).empty());
    CHECK(ortho(1, -1, 0, 1).starts_with("umbrage::orthographic: low and high "));
    CHECK(ortho(-greatest, greatest, 0, 1).starts_with("umbrage::orthographic: low and high "));
    CHECK(ortho(0, denormal, 0, 1).starts_with("umbrage::orthographic: low and high "));
    CHECK(ortho(-1, 1, -3e38f, 3e38f).starts_with("umbrage::orthographic: z_near and z_far "));
    CHECK(ortho(-1, 1, 0, denormal).starts_with("umbrage::orthographic: z_near and z_far "));
    CHECK(ortho(-1, 1, 0, greatest).starts_with("umbrage::orthographic: z_near and z_far "));  // a denormal slope
    CHECK(ortho(-1, 1, 1, 1).starts_with("umbrage::orthographic: z_near and z_far "));
}
