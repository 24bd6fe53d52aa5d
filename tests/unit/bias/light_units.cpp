// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

namespace {

/// A texel's footprint is one texel wide in the map, and a short way along the light is as much depth.
template <class T>
void check_units(const light_space<T>& light, glm::dvec3 axis, glm::dvec3 point) {
    const glm::ivec2 size(300, 300);
    const glm::mat<4, 4, T> to_texels = texture_matrix(light, size);
    const glm::vec<2, T> units = make_light_units(light, size);
    const T w = shadow_coordinate(to_texels, glm::vec<3, T>(point)).w;
    const double relative = sizeof(T) == 4 ? 1e-3 : 1e-4;

    const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.2, 0.9)));
    const double texel = double(texels_to_world(T(1), units, w));
    const glm::dvec3 from = through(to_texels, point), to = through(to_texels, point + 100.0 * texel * side);
    CHECK(glm::length(glm::dvec2(to) - glm::dvec2(from)) == doctest::Approx(100.0).epsilon(relative));

    const double step = 1e-3 * double(w);
    const glm::dvec3 before = through(to_texels, point - 0.5 * step * axis);
    const glm::dvec3 behind = through(to_texels, point + 0.5 * step * axis);
    CHECK(double(world_to_depth(T(step), units, w)) ==
          doctest::Approx(std::abs(behind.z - before.z)).epsilon(sizeof(T) == 4 ? 0.02 : relative));
    CHECK(double(world_to_depth(T(step), units, w)) > 0);
}

}  // namespace

TEST_CASE_TEMPLATE("make_light_units: spot and directional, every clip space, near and far", T, float, double) {
    using vec = glm::vec<3, T>;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (const clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::dvec3 position(1, 5, 2), axis = glm::normalize(glm::dvec3(-0.2, -1, 0.3));
        for (const T z_far : {T(20), std::numeric_limits<T>::infinity()})
            for (int i = 0; i < 5; ++i)
                check_units(
                    make_spot_light<T>(
                        {.position = vec(position), .direction = vec(axis), .z_near = 1, .z_far = z_far, .clip = clip}),
                    axis,
                    position + (5.0 + 3.0 * coordinate(random)) * axis +
                        glm::dvec3(coordinate(random), 0, coordinate(random)));
        const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -2, 0.5));
        check_units(make_directional_light<T>({.direction = vec(direction), .map_size = 300, .clip = clip}), direction,
                    glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
    }
}

TEST_CASE("make_light_units: by hand, and what is refused") {
    // 300 texels over 30 units, 0.1 to 100 before the light
    const auto sun = make_directional_light<double>({.map_size = 300});
    CHECK(make_light_units(sun, {300, 300}).x == doctest::Approx(0.1));
    CHECK(make_light_units(sun, {300, 300}).y == doctest::Approx(1 / 99.9));
    CHECK(make_light_units(sun, {300, 150}).x == doctest::Approx(0.2));  // the longer edge
    const auto spot = make_spot_light<double>({.outer_angle_radians = std::atan(0.5), .z_near = 1, .z_far = 3});
    CHECK(make_light_units(spot, {100, 100}).x == doctest::Approx(0.01));
    CHECK(make_light_units(spot, {100, 100}).y == doctest::Approx(1.5));  // depth 1.5 - 1.5 / w
    for (glm::ivec2 none : {glm::ivec2(0, 1), glm::ivec2(1, 0), glm::ivec2(-1)})
        CHECK(complaint([&] { static_cast<void>(make_light_units(sun, none)); }) ==
              "umbrage::make_light_units: map_size must be above 0");
    light_space<float> flat;
    flat.projection[2][2] = 0;
    CHECK(complaint([&] {
              static_cast<void>(make_light_units(flat, {1, 1}));
          }) == "umbrage::make_light_units: light gives measures that are not finite and above 0");
    flat.projection = glm::mat4(std::numeric_limits<float>::quiet_NaN());
    CHECK(!complaint([&] { static_cast<void>(make_light_units(flat, {1, 1})); }).empty());
}

TEST_CASE_TEMPLATE("texels_to_world, world_to_depth: out of range", T, float, double) {
    using vec = glm::vec<2, T>;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const vec units(T(0.5), T(0.25));
    CHECK(texels_to_world(T(4), units, T(2)) == 4);
    CHECK(world_to_depth(T(4), units, T(2)) == T(0.25));
    for (T w : {T(0), T(-1), inf, -inf, nan, T(0x1p64)}) CHECK(texels_to_world(T(1), vec(1), w) == 0);
    for (T w : {T(0), nan, T(0x1p-80)}) CHECK(world_to_depth(T(1), units, w) == 1);
    CHECK(world_to_depth(T(1), units, inf) == 0);
    CHECK(world_to_depth(inf, units, T(1)) == 1);
    CHECK(world_to_depth(nan, units, T(1)) == 1);
    CHECK(world_to_depth(T(-1), units, T(1)) == 0);
    CHECK(texels_to_world(nan, units, T(1)) == 0);
}
