// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("normal_offset: by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec down(0, 0, -1);
    const auto of = [&](vec normal, T width, T error) { return normal_offset(normal, down, down, width, error); };
    CHECK(of(vec(0, 0, 1), T(2), T(0)) == vec(0));
    CHECK(of(vec(0, 0, 1), T(2), T(0.5)) == vec(0, 0, T(0.5)));
    CHECK(of(vec(1, 0, 0), T(2), T(0.5)) == vec(2, 0, 0));
    CHECK(glm::length(of(vec(T(0.6), 0, T(0.8)), T(2), T(1)) - vec(T(0.6), 0, T(0.8)) * T(2)) < T(1e-6));
    CHECK(offset_width(T(1), T(1)) * offset_width(T(1), T(1)) > T(2));
    CHECK(offset_width(T(1.5), T(0.1)) == doctest::Approx(0.15 * std::sqrt(2.0)));
}

TEST_CASE_TEMPLATE("normal_offset: zero normal, NaN, infinite: no offset", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec slanted(T(0.6), 0, T(0.8)), down(0, 0, -1);
    CHECK(normal_offset(vec(0), down, down, T(1), T(1)) == vec(0));
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (T bad : {inf, -inf, nan, -nan, T(0x1p80)}) {
        for (int i = 0; i < 3; ++i) {
            vec v = slanted;
            v[i] = bad;
            CHECK(normal_offset(v, down, down, T(1), T(1)) == vec(0));
            if (!is_finite(bad)) CHECK(normal_offset(slanted, v, down, T(1), T(1)) == vec(0));
        }
        CHECK(normal_offset(slanted, down, down, bad, T(1)) == vec(0));
        CHECK(normal_offset(slanted, down, down, T(1), bad) == vec(0));
        CHECK(normal_offset(slanted, down, vec(bad), T(1), T(1)) == vec(0));
    }
}

TEST_CASE(
    "normal_offset: no texel within reach holds the plane nearer than the point is, and 0.9 of it is too little") {
    std::mt19937 random(5);
    std::normal_distribution<double> coordinate;
    const glm::dvec3 position(1, 5, 2);
    for (const clip_space clip : all_clip_spaces())
        for (const bool spot : {false, true}) {
            const glm::dvec3 direction = glm::normalize(spot ? glm::dvec3(-0.2, -1, 0.3) : glm::dvec3(1, -2, 0.5));
            const light_space<double> light =
                spot
                    ? make_spot_light<double>({.position = position, .direction = direction, .z_near = 1, .clip = clip})
                    : make_directional_light<double>({.direction = direction, .texels_per_unit = 128, .clip = clip});
            const glm::ivec2 size(1024);
            const glm::dmat4 to_texels = texture_matrix(light, size), planes = plane_matrix(to_texels);
            const glm::dvec2 units = make_light_units(light, size);
            const double reach = 2.5, away = clip.direction == depth_direction::forward ? 1 : -1;
            int taken = 0, dark = 0, too_little = 0;
            while (taken < 500) {
                const glm::dvec3 normal =
                    glm::normalize(glm::dvec3(coordinate(random), coordinate(random), coordinate(random)));
                const glm::dvec3 point(coordinate(random), coordinate(random) * 0.3, coordinate(random));
                const double w = shadow_coordinate(to_texels, point).w;
                const glm::dvec3 way = spot ? (point - position) / w : direction;
                if (glm::dot(normal, way) > -0.05 || glm::dot(normal, direction) > 0 || w < 1) continue;
                ++taken;
                const glm::dvec2 slope = plane_slope(planes, normal, point);
                const glm::dvec3 on_plane = through(to_texels, point);
                // how far before the point's own depth the plane comes within reach of it
                const auto nearer = [&](glm::dvec3 offset) {
                    const glm::dvec3 p = through(to_texels, point + offset);
                    const glm::dvec2 moved = glm::dvec2(p) - glm::dvec2(on_plane);
                    const double plane = on_plane.z + slope.x * moved.x + slope.y * moved.y;
                    return away * (p.z - plane) + reach * (std::abs(slope.x) + std::abs(slope.y));
                };
                const double width = offset_width(reach, texels_to_world(1.0, units, w));
                const glm::dvec3 offset = normal_offset(normal, direction, way, width, 0.0);
                dark += nearer(offset) > 1e-12;
                too_little += nearer(0.9 * offset) > 1e-9;
            }
            CAPTURE(to_string(clip));
            CAPTURE(spot);
            CHECK(dark == 0);
            CHECK(too_little > 100);  // of planes that lie askew to the texels
        }
}
