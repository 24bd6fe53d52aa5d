// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/tetrahedron_light.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../clip_spaces.hpp"
#include "../directions.hpp"

using namespace umbrage;

TEST_CASE(
    "make_tetrahedron_light: tetrahedron_texel's texels and per-face depths, in every convention, with and "
    "without a border") {
    std::mt19937 random(1);
    for (const clip_space clip : all_clip_spaces())
        for (const int border : {0, 3}) {
            CAPTURE(to_string(clip));
            const tetrahedron_light<double> light{
                .position = {3, -2, 7}, .z_near = 0.25, .z_far = 40, .map_size = 64, .border = border, .clip = clip};
            const auto faces = make_tetrahedron_light(light);
            double apart = 0;
            for (int i = 0; i < 2000; ++i) {
                const glm::dvec3 direction = 5.0 * directions::any(random), at = tetrahedron_coordinate(direction);
                const auto& face = faces[static_cast<std::size_t>(at.z)];
                const glm::dvec3 texel = through(texture_matrix(face, {64, 64}), light.position + direction);
                const double z = tetrahedron_view_z(direction);
                const double depth = clip.direction == depth_direction::forward
                                         ? depth_from_view_z(z, 0.25, 40.0)
                                         : reversed_depth_from_view_z(z, 0.25, 40.0);
                const glm::dvec3 expected(tetrahedron_texel(at, 64.0, double(border)), depth);
                for (glm::length_t k = 0; k < 3; ++k) apart = worse(apart, std::abs(texel[k] - expected[k]));
            }
            CHECK(apart < 1e-9);
        }
}

TEST_CASE("make_tetrahedron_light: any triangles, of which a border is taken off") {
    const std::array<tetrahedron_tile<double>, 4> tiles{{{{{3, 2}, {60, 9}, {20, 40}}},
                                                         {{{20, 40}, {60, 9}, {3, 2}}},  // the other way round
                                                         {{{0, 0}, {64, 0}, {0, 64}}},
                                                         {{{64, 64}, {64, 10}, {10, 64}}}}};
    std::mt19937 random(2);
    for (const int border : {0, 2}) {
        const auto faces =
            make_tetrahedron_light<double>({.map_size = 64, .border = border, .clip = cpu_clip_space}, tiles);
        int outside = 0;
        double apart = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec3 d = directions::any(random);
            const int face = tetrahedron_face(d);
            const auto& t = tiles[std::size_t(face)];
            const glm::dvec2 p(through(texture_matrix(faces[std::size_t(face)], {64, 64}), d));
            const auto turn = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
            const double whole = turn(t[1] - t[0], t[2] - t[0]);
            for (const glm::dvec2 tap : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}})
                for (std::size_t k = 0; k < 3; ++k)
                    outside += turn(t[(k + 1) % 3] - t[k], p + tap * double(border) - t[k]) / whole < -1e-12;
            if (border > 0) continue;
            double sum = 0;
            glm::dvec2 expected(0);
            for (int j = 0, corner = 0; j < 4; ++j) {
                if (j == face) continue;
                const double b = 0.75 * glm::dot(tetrahedron_normal<double>(face) - tetrahedron_normal<double>(j), d);
                sum += b, expected += b * t[std::size_t(corner++)];
            }
            apart = worse(apart, glm::distance(p, expected / sum));
        }
        CHECK(outside == 0);
        CHECK(apart < 1e-9);
    }
}

TEST_CASE("make_tetrahedron_light: what is wrong is named") {
    using light = tetrahedron_light<float>;
    const auto of = [](auto change) {
        light l{.clip = cpu_clip_space};
        change(l);
        const std::string message = complaint([&] { (void)make_tetrahedron_light(l); });
        const auto begin = message.find(": ");
        return message.empty() ? message : message.substr(begin + 2, message.find(" must") - begin - 2);
    };
    CHECK(of([](light&) {}).empty());
    CHECK(of([](light& l) { l.z_far = std::numeric_limits<float>::infinity(); }).empty());
    CHECK(of([](light& l) { l.map_size = 16, l.border = 2; }).empty());
    CHECK(of([](light& l) { l.map_size = 16, l.border = 3; }) == "border");
    CHECK(of([](light& l) { l.border = -1; }) == "border");
    CHECK(of([](light& l) { l.border = std::numeric_limits<int>::max(); }) == "border");
    CHECK(of([](light& l) { l.map_size = 0; }) == "map_size");
    CHECK(of([](light& l) { l.z_near = 0; }) == "z_near");
    CHECK(of([](light& l) { l.z_near = 3e-4f; }) == "z_near");  // no digits at 100
    CHECK(of([](light& l) { l.z_near = 3e-4f, l.clip.direction = depth_direction::reversed; }).empty());
    CHECK(of([](light& l) { l.z_far = l.z_near; }) == "z_far");
    CHECK(of([](light& l) { l.position.y = std::nanf(""); }) == "position");
}
