// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point_light.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/depth/kinds.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "clip_spaces.hpp"

using namespace umbrage;

TEST_CASE(
    "make_point_light: cube_coordinate's texels and per-face depths, in every convention, with and without a border") {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const clip_space clip : all_clip_spaces())
        for (const int border : {0, 3}) {
            CAPTURE(to_string(clip));
            const point_light<double> light{
                .position = {3, -2, 7}, .z_near = 0.25, .z_far = 40, .map_size = 64, .border = border, .clip = clip};
            const auto faces = make_point_light(light);
            double apart = 0;
            for (int i = 0; i < 2000; ++i) {
                const double x = normal(random), y = normal(random), z = normal(random);
                const glm::dvec3 direction = 5.0 * glm::dvec3(x, y, z), at = cube_coordinate(direction);
                const auto& face = faces[static_cast<std::size_t>(at.z)];
                const glm::dvec3 texel = through(texture_matrix(face, {64, 64}), light.position + direction);
                const double m = cube_view_z(direction);
                const double depth = clip.direction == depth_direction::forward
                                         ? depth_from_view_z(m, 0.25, 40.0)
                                         : reversed_depth_from_view_z(m, 0.25, 40.0);
                const glm::dvec3 expected(glm::dvec2(at) * (64.0 - 2 * border) + double(border), depth);
                for (glm::length_t k = 0; k < 3; ++k) apart = worse(apart, std::abs(texel[k] - expected[k]));
            }
            CHECK(apart < 1e-9);
        }
}

TEST_CASE("make_point_light: what is wrong is named") {
    const auto of = [](auto change) {
        point_light<float> light;
        change(light);
        const std::string message = complaint([&] { (void)make_point_light(light); });
        const auto begin = message.find(": ");
        return message.empty() ? message : message.substr(begin + 2, message.find(" must") - begin - 2);
    };
    using light = point_light<float>;
    CHECK(of([](light&) {}).empty());
    CHECK(of([](light& l) { l.z_far = std::numeric_limits<float>::infinity(); }).empty());
    CHECK(of([](light& l) { l.border = -1; }) == "border");
    CHECK(of([](light& l) { l.border = 256; }) == "map_size");
    CHECK(of([](light& l) { l.border = std::numeric_limits<int>::max(); }) == "map_size");
    CHECK(of([](light& l) { l.map_size = 0; }) == "map_size");
    CHECK(of([](light& l) { l.map_size = -5; }) == "map_size");
    CHECK(of([](light& l) { l.z_near = 0; }) == "z_near");
    CHECK(of([](light& l) { l.z_far = l.z_near; }) == "z_far");
    CHECK(of([](light& l) { l.position.y = std::nanf(""); }) == "position");
}
