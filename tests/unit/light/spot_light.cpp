// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "clip_spaces.hpp"

using namespace umbrage;

namespace {

constexpr glm::ivec2 map_size{640, 480};

spot_light<double> tilted(clip_space clip) {
    return {.position = in_world({3, 8, -2}, clip),
            .direction = in_world({-1, -3, 0.5}, clip),
            .up = in_world({0.1, 1, 0.3}, clip),
            .outer_angle_radians = 0.7,
            .z_near = 0.5,
            .z_far = 40.0,
            .clip = clip};
}

}  // namespace

TEST_CASE("make_spot_light: the same point of the scene, the same texel and depth in every convention") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-20, 20);
    const glm::dmat4 plain = texture_matrix(make_spot_light(tilted({})), map_size);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dmat4 m = texture_matrix(make_spot_light(tilted(clip)), map_size);
        double worst = 0;
        int tried = 0;
        while (tried < 200) {
            const glm::dvec3 world(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec4 in_front = plain * glm::dvec4(world, 1);
            if (in_front.w < 0.5) continue;
            ++tried;
            glm::dvec3 expected = glm::dvec3(in_front) / in_front.w;
            if (clip.origin == texture_origin::top) expected.y = map_size.y - expected.y;
            if (clip.direction == depth_direction::reversed) expected.z = 1.0 - expected.z;
            const glm::dvec3 got = through(m, in_world(world, clip));
            worst = worse(worst, glm::length(got - expected) / (1 + glm::length(expected)));
        }
        CHECK(worst < 1e-12);
    }
}

TEST_CASE("make_spot_light: depth runs from the near plane to the far plane, w is the distance") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto light = tilted(clip);
        const glm::dmat4 m = texture_matrix(make_spot_light(light), map_size);
        const glm::dvec3 axis = glm::normalize(light.direction);
        const bool reversed = clip.direction == depth_direction::reversed;
        const glm::dvec3 at_near = through(m, light.position + axis * light.z_near);
        const glm::dvec3 at_far = through(m, light.position + axis * light.z_far);
        CHECK(glm::length(at_near - glm::dvec3(320, 240, reversed ? 1 : 0)) < 1e-10);
        CHECK(glm::length(at_far - glm::dvec3(320, 240, reversed ? 0 : 1)) < 1e-10);
        double before = reversed ? 2 : -2;
        for (double distance = light.z_near; distance < light.z_far; distance *= 1.1) {
            const glm::dvec4 h = m * glm::dvec4(light.position + axis * distance, 1);
            CHECK(h.w == doctest::Approx(distance));
            const double depth = h.z / h.w;
            CHECK((reversed ? depth < before : depth > before));
            before = depth;
        }
    }
}

TEST_CASE("make_spot_light: the cone's edge touches the map's edges and never leaves the map") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto light = tilted(clip);
        const auto space = make_spot_light(light);
        const glm::dmat4 uv = texture_matrix_uv(space);
        const glm::dmat4 back = glm::inverse(space.view);
        const double front = clip.hand == handedness::right ? -1 : 1;
        glm::dvec2 low(2), high(-1);
        for (int i = 0; i < 360; ++i) {
            const double turn = i * std::numbers::pi / 180, extent = std::tan(light.outer_angle_radians);
            const glm::dvec4 edge =
                back * glm::dvec4(extent * std::cos(turn) * 5, extent * std::sin(turn) * 5, 5 * front, 1);
            const glm::dvec2 p(through(uv, glm::dvec3(edge)));
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        CHECK(glm::length(low) < 1e-12);
        CHECK(glm::length(high - 1.0) < 1e-12);
    }
}

TEST_CASE("make_spot_light: straight down and straight up") {
    for (clip_space clip : all_clip_spaces())
        for (float sign : {-1.0f, 1.0f}) {
            const auto light = make_spot_light({.position = {1, 2, 3}, .direction = {0, sign, 0}, .clip = clip});
            const glm::dvec3 p = through(texture_matrix(light, {100, 100}), {1, 2 + 10 * sign, 3});
            CHECK(glm::length(glm::dvec2(p) - 50.0) < 1e-4);
            CHECK((p.z > 0 && p.z < 1));
        }
}

TEST_CASE("make_spot_light: float is double, rounded") {
    for (clip_space clip : all_clip_spaces()) {
        const auto d = tilted(clip);
        const auto f = make_spot_light<float>({.position = d.position,
                                               .direction = d.direction,
                                               .up = d.up,
                                               .outer_angle_radians = 0.7f,
                                               .z_near = 0.5f,
                                               .z_far = 40.0f,
                                               .clip = clip});
        const auto exact = make_spot_light(d);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) {
                CHECK(std::abs(double(f.view[c][r]) - exact.view[c][r]) < 4e-6);
                CHECK(std::abs(double(f.projection[c][r]) - exact.projection[c][r]) < 1e-6);
            }
        CHECK(f.clip == clip);
    }
}

TEST_CASE_TEMPLATE("make_spot_light: bad input", T, float, double) {
    const auto with = [](auto change) {
        spot_light<T> light;
        change(light);
        (void)make_spot_light(light);
    };
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    CHECK_NOTHROW(with([](auto&) {}));
    for (T angle : {T(0), T(-1), T(-0.0), T(2), std::numbers::pi_v<T> / 2, nan, infinity, -infinity})
        CHECK_THROWS_AS(with([&](auto& l) { l.outer_angle_radians = angle; }), std::invalid_argument);
    CHECK_NOTHROW(with([](auto& l) { l.outer_angle_radians = std::nextafter(std::numbers::pi_v<T> / 2, T(0)); }));
    CHECK_THROWS_AS(with([](auto& l) { l.direction = {0, 0, 0}; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.direction.y = nan; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.position.z = infinity; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = 0; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = -1; }), std::invalid_argument);
    CHECK_THROWS_AS(with([](auto& l) { l.z_near = l.z_far; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.z_far = infinity; }), std::invalid_argument);
    CHECK_THROWS_AS(with([&](auto& l) { l.z_near = nan; }), std::invalid_argument);
}
