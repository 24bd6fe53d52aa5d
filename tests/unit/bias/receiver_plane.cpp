// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/filter/filters.hpp>

#include "../rounds.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("receiver_plane_slope: by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    // depth 0.25 x - 0.125 y, two texels a pixel along x and four along y, then turned
    const vec straight = receiver_plane_slope(vec(2, 0, T(0.5)), vec(0, 4, T(-0.5)));
    CHECK(straight.x == T(0.25));
    CHECK(straight.y == T(-0.125));
    CHECK(straight.z == doctest::Approx(3.3 * (0x1p-25 + 0.375 * 0x1p-13) * 6 / 8));
    const vec turned = receiver_plane_slope(vec(1, 2, 0), vec(-2, 1, T(-0.625)));
    CHECK(turned.x == T(0.25));
    CHECK(turned.y == T(-0.125));
    CHECK(receiver_plane_slope(vec(1, 0, 5), vec(0, 1, -9)).x == 2);
    CHECK(receiver_plane_slope(vec(1, 0, 5), vec(0, 1, -9)).y == -2);
}

TEST_CASE_TEMPLATE("receiver_plane_slope: nothing is known of a plane seen edge-on, magnified too much, of NaN", T,
                   float, double) {
    using vec = glm::vec<3, T>;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(receiver_plane_slope(vec(0), vec(0)) == vec(0));
    CHECK(receiver_plane_slope(vec(1, 2, 1), vec(2, 4, 3)) == vec(0));
    CHECK(receiver_plane_slope(vec(T(0x1p-11), 0, 1), vec(0, T(0x1p-11), 1)) == vec(0));
    CHECK(receiver_plane_slope(vec(T(0x1p70), 0, 1), vec(0, T(0x1p70), 1)) == vec(0));
    for (T bad : {inf, -inf, nan, -nan})
        for (int i = 0; i < 6; ++i) {
            vec d[2]{vec(1, 0, T(0.1)), vec(0, 1, T(0.1))};
            d[i / 3][i % 3] = bad;
            const vec plane = receiver_plane_slope(d[0], d[1]);
            for (int k = 0; k < 3; ++k) CHECK((plane[k] >= -2 && plane[k] <= 2));
            if (i % 3 < 2) CHECK(plane == vec(0));
        }
}

TEST_CASE("receiver_plane_slope: the slope of coordinates rounded to float is off by no more than it says") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> tilt(-8, 0), place(100, 3900), turn(0, 6.3), squeeze(0.02, 1);
    double worst = 0;
    int known = 0;
    for (int i = 0; i < rounds(300000); ++i) {
        const double texels = std::exp2(tilt(random)), steep = std::exp2(2 * tilt(random) - 4);
        const glm::dvec2 slope = steep * glm::dvec2(std::cos(turn(random)), std::sin(turn(random)));
        const double angle = turn(random), narrow = texels * squeeze(random);
        const glm::dvec2 across(texels * std::cos(angle), texels * std::sin(angle));
        const glm::dvec2 up(-narrow * std::sin(angle), narrow * std::cos(angle));
        const glm::dvec2 here(place(random), place(random));
        const auto seen = [&](glm::dvec2 p) {
            return glm::vec3(p, 0.5 + slope.x * (p.x - here.x) + slope.y * (p.y - here.y));
        };
        const glm::vec3 at = seen(here);
        const glm::vec3 plane = receiver_plane_slope(seen(here + across) - at, seen(here + up) - at);
        if (plane == glm::vec3(0)) continue;
        ++known;
        const double off = std::abs(double(plane.x) - slope.x) + std::abs(double(plane.y) - slope.y);
        worst = std::max(worst, off / double(plane.z));
    }
    CHECK(known > rounds(200000));
    CHECK(worst <= 1);
    CHECK(worst > 0.2);
}

TEST_CASE_TEMPLATE("plane_reference: by hand, at the texel's center, and never farther than the receiver", T, float,
                   double) {
    using vec = glm::vec<2, T>;
    const vec slope(T(0.25), T(-0.125)), coord(T(3.25), T(7.5));
    CHECK(plane_reference(T(0.5), slope, coord, vec(2, 7)) == T(0.3125));  // three quarters of a texel to its left
    CHECK(plane_reference(T(0.5), slope, coord, vec(3, 9)) == T(0.3125));
    CHECK(plane_reference(T(0.5), slope, coord, vec(4, 7)) == T(0.5));
    CHECK(plane_reference(T(0.5), slope, coord, vec(4, 7), greater_equal{}) == T(0.8125));
    CHECK(plane_reference(T(0.5), slope, coord, vec(2, 7), greater_equal{}) == T(0.5));
}

TEST_CASE_TEMPLATE("corner_reference: plane_reference where four texels meet", T, float, double) {
    using vec = glm::vec<2, T>;
    const vec slope(T(0.25), T(-0.125)), coord(T(3.25), T(7.5));
    for (const vec corner : {vec(3, 7), vec(4, 8), vec(2, 9)})
        for (const depth_direction direction : {depth_direction::forward, depth_direction::reversed})
            CHECK(corner_reference(T(0.5), slope, corner - coord, comparison{direction}) ==
                  plane_reference(T(0.5), slope, coord, corner - T(0.5), comparison{direction}));
    CHECK(corner_reference(T(0.5), slope, vec(T(-0.25), T(0.5))) == T(0.375));
    CHECK(corner_reference(T(0.5), slope, vec(T(0.25), T(-0.5)), greater_equal{}) == T(0.625));
    CHECK(corner_reference(T(0.5), vec(std::numeric_limits<T>::quiet_NaN()), vec(1)) == T(0.5));
}

TEST_CASE_TEMPLATE("bordered_plane_reference: inside as plane_reference, outside before every depth", T, float,
                   double) {
    using vec = glm::vec<2, T>;
    const vec slope(T(0.125), T(-0.25)), coord(3, 7);
    for (const vec texel : {vec(2, 7), vec(3, 9), vec(4, 7)}) {
        CHECK(bordered_plane_reference(T(0.5), slope, coord, texel, texel) ==
              plane_reference(T(0.5), slope, coord, texel));
        CHECK(bordered_plane_reference(T(0.5), slope, coord, texel, texel, greater_equal{}) ==
              plane_reference(T(0.5), slope, coord, texel, greater_equal{}));
        for (const vec inside : {texel + vec(1, 0), texel - vec(0, 1), texel + vec(1, 1)}) {
            CHECK(bordered_plane_reference(T(0.5), slope, coord, texel, inside) < -1e6);
            CHECK(bordered_plane_reference(T(0.5), slope, coord, texel, inside, greater_equal{}) > 1e6);
        }
    }
}

TEST_CASE("apply_receiver_plane: a texel lit along the plane has the far plane's depth, others their own") {
    const glm::vec2 slope(0.25f, -0.125f);
    const glm::vec3 at(3.25f, 7.5f, 0.5f);
    const auto taken = [&](float stored, glm::ivec2 texel, depth_direction direction = depth_direction::forward) {
        return apply_receiver_plane([stored](glm::ivec2) { return stored; }, slope, at, direction)(texel);
    };
    CHECK(taken(0.3125f, {2, 7}) == 1);
    CHECK(taken(0.3124f, {2, 7}) == 0.3124f);
    CHECK(taken(0.4999f, {4, 7}) == 0.4999f);
    CHECK(taken(0.8125f, {4, 7}, depth_direction::reversed) == 0);
    CHECK(taken(0.8126f, {4, 7}, depth_direction::reversed) == 0.8126f);
    CHECK(is_nan(taken(std::numeric_limits<float>::quiet_NaN(), {3, 7})));
}

TEST_CASE("apply_receiver_plane: no filter darkens a plane, without any bias by its reach") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> steep(-0x1p-6f, 0x1p-6f), place(10, 22);
    for_each_filter([&](auto filter) {
        CAPTURE(filter.name);
        for (auto direction : {depth_direction::forward, depth_direction::reversed}) {
            if constexpr (requires { filter.direction = direction; }) filter.direction = direction;
            else if (direction == depth_direction::reversed) continue;
            int dark = 0, dark_without = 0;
            for (int i = 0; i < 200; ++i) {
                const glm::dvec2 slope(steep(random), steep(random));
                image<float> map({32, 32});
                const auto depth = [&](glm::dvec2 p) {
                    return static_cast<float>(0.5 + slope.x * (p.x - 16) + slope.y * (p.y - 16));
                };
                for (int y = 0; y < 32; ++y)
                    for (int x = 0; x < 32; ++x) map[{x, y}] = depth(glm::dvec2(x, y) + 0.5);
                for (int k = 0; k < 50; ++k) {
                    const glm::vec2 coord(place(random), place(random));
                    const float receiver = biased(depth(coord), 0x1p-22f, filter.direction);
                    dark_without += filter(clamped(map), coord, receiver) < 1.0f;
                    dark += filter(apply_receiver_plane(clamped(map), slope, glm::vec3(coord, receiver), direction),
                                   coord, receiver) < 1.0f;
                }
            }
            CHECK(dark == 0);
            CHECK(dark_without > 3000);
        }
    });
}
