// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>

#include "../light/clip_spaces.hpp"
#include "../light/reference_view.hpp"

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
        check_units(make_directional_light<T>({.direction = vec(direction), .map_size = {300, 300}, .clip = clip}),
                    direction, glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
    }
}

TEST_CASE_TEMPLATE("light_units_at: as make_light_units has it, spot and directional, every clip space", T, float,
                   double) {
    using vec = glm::vec<3, T>;
    const vec position(1, 5, 2), axis(T(-0.2), -1, T(0.3)), point(T(0.7), 1, T(2.5));
    for (const clip_space clip : all_clip_spaces()) {
        const auto check = [&](const light_space<T>& light) {
            const glm::mat<4, 4, T> to_texels = texture_matrix(light, {300, 300});
            const glm::vec<2, T> units = make_light_units(light, {300, 300});
            const T w = shadow_coordinate(to_texels, point).w;
            const auto [here, drift] = light_units_at(to_texels, axis, point);
            CHECK(here.x == doctest::Approx(units.x * w).epsilon(1e-4));
            CHECK(here.y == doctest::Approx(units.y / (w * w)).epsilon(1e-4));
            CHECK(double(drift) < (sizeof(T) == 4 ? 1e-5 : 1e-13));
        };
        check(make_spot_light<T>({.position = position, .direction = axis, .z_near = 1, .clip = clip}));
        check(make_directional_light<T>({.direction = axis, .map_size = {300, 300}, .clip = clip}));
    }
}

TEST_CASE(
    "light_units_at: of warped maps, by steps of texels all around and along the light; a bias that moves points") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (int i = 0; i < 64; ++i) {
        warp_fit<double> fit{.receivers = bounding_box<double>{}, .clip = all_clip_spaces()[std::size_t(i % 16)]};
        fit.camera = {.position = {0, 2, 0}, .direction = {coordinate(random), 0, -1}};
        fit.direction = {coordinate(random), -1, coordinate(random)};
        const auto light = fit_light_space_perspective(fit).light;
        CHECK(complaint([&] {
                  (void)make_light_units(light, {300, 300});
              }).ends_with("light_units_at measures a point."));
        const glm::dmat4 m = texture_matrix(light, {300, 200});
        const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random)),
            d = glm::normalize(fit.direction);
        const auto [here, drift] = light_units_at(m, fit.direction, p);
        const glm::dvec3 side = glm::normalize(glm::cross(d, glm::dvec3(1, 2, 3))), up = glm::cross(d, side);
        const glm::dvec3 at = through(m, p);
        double shortest = 1e9;  // in texels, of a small way across the light
        for (int k = 0; k < 720; ++k) {
            const double turn = k * 0.00436332;
            const glm::dvec3 way = std::cos(turn) * side + std::sin(turn) * up;
            shortest = std::min(shortest, glm::length(glm::dvec2(through(m, p + 1e-6 * way)) - glm::dvec2(at)));
        }
        CHECK(here.x == doctest::Approx(1e-6 / shortest).epsilon(1e-3));
        const glm::dmat4 back = glm::inverse(m);
        double drifted = 0;
        for (const glm::dvec2 texel : {glm::dvec2(1, 0), glm::dvec2(0, 1)}) {
            // where the next texel meets the plane across the light through the point
            const glm::dvec3 from = through(back, at + glm::dvec3(1e-4 * texel, 0)),
                             to = through(back, at + glm::dvec3(1e-4 * texel, 1e-3));
            const glm::dvec3 level = from + (to - from) * (glm::dot(p - from, d) / glm::dot(to - from, d));
            drifted += std::abs(through(m, level).z - at.z) / 1e-4 / here.y;
        }
        CHECK(drift == doctest::Approx(drifted).epsilon(1e-3));
        const double moved = through(m, p - 0.02 * d).z - at.z;
        CHECK(std::abs(moved) == doctest::Approx(world_to_depth(0.02, here, 1.0)).epsilon(1e-9));
    }
}

TEST_CASE("light_units_at: a bias in world units keeps a warped map's planes off what their texels hold") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    int drifts = 0;
    for (const auto& light : reference_view::suns) {
        const warp_fit<double> fit = reference_view::warp_under(light);
        const glm::dmat4 m = texture_matrix(fit_light_space_perspective(fit).light, reference_view::map_size);
        const glm::dmat4 planes = plane_matrix(m);
        const glm::dvec3 d = glm::normalize(fit.direction);
        for (int i = 0; i < 300; ++i) {
            const double z = 3 * std::pow(300.0, 0.5 + 0.5 * coordinate(random)), x = coordinate(random);
            const glm::dvec3 p(x * z, 0, -z), tilt(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec3 normal = glm::normalize(-d + tilt);
            if (glm::dot(normal, d) > -0.1) continue;
            const auto here = light_units_at(m, d, p);
            const glm::dvec2 slope = plane_slope(planes, normal, p);
            const glm::dvec3 at = through(m, p);
            for (const double reach : {0.5, 1.5, 5.5}) {
                const double needed = reach * (std::abs(slope.x) + std::abs(slope.y));
                const double tilted = kernel_bias(normal, d, d, offset_width(reach, here.units.x), 20.0);
                const double bias = tilted + reach * here.drift_world;
                const glm::dvec3 moved = through(m, p - bias * d);
                CHECK(at.z - moved.z > needed);
                CHECK(glm::length(glm::dvec2(at) - glm::dvec2(moved)) < 1e-6);
                CHECK(world_to_depth(bias, here.units, 1.0) ==
                      doctest::Approx(std::min(at.z - moved.z, 1.0)).epsilon(1e-6));
                drifts += world_to_depth(tilted, here.units, 1.0) < needed;
            }
        }
    }
    CHECK(drifts > 500);
}

TEST_CASE("make_light_units: by hand, and what is refused") {
    // 300 texels over 30 units, 0.1 to 100 before the light
    const auto sun = make_directional_light<double>({.map_size = {300, 300}, .clip = cpu_clip_space});
    CHECK(make_light_units(sun, {300, 300}).x == doctest::Approx(0.1));
    CHECK(make_light_units(sun, {300, 300}).y == doctest::Approx(1 / 99.9));
    CHECK(make_light_units(sun, {300, 150}).x == doctest::Approx(0.2));  // the longer edge
    const auto spot = make_spot_light<double>(
        {.outer_angle_radians = std::atan(0.5), .z_near = 1, .z_far = 3, .clip = cpu_clip_space});
    CHECK(make_light_units(spot, {100, 100}).x == doctest::Approx(0.01));
    CHECK(make_light_units(spot, {100, 100}).y == doctest::Approx(1.5));  // depth 1.5 - 1.5 / w
    const point_light<double> bulb{.z_near = 1, .z_far = 3, .map_size = 104, .border = 2, .clip = cpu_clip_space};
    CHECK(make_light_units(bulb).x == doctest::Approx(0.02));  // 100 texels over 90 degrees, 2 units at a distance of 1
    CHECK(make_light_units(bulb).y == doctest::Approx(1.5));
    for (glm::ivec2 none : {glm::ivec2(0, 1), glm::ivec2(1, 0), glm::ivec2(-1)})
        CHECK(complaint([&] { static_cast<void>(make_light_units(sun, none)); }) ==
              "umbrage::make_light_units: map_size must be above 0; got " + detail::printed(none));
    light_space<float> flat{.clip = cpu_clip_space};
    flat.projection[2][2] = 0;
    CHECK(
        complaint([&] {
            static_cast<void>(make_light_units(flat, {1, 1}));
        }) ==
        "umbrage::make_light_units: light and map_size must be such that units are finite and above 0; got (2, 2, 0)");
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
