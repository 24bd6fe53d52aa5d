// SPDX-License-Identifier: MIT
//
// Cascades of cameras of every kind: the oracle is points that an eye sees by its own matrix.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>

#include "../../cameras.hpp"
#include "../../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("make_stable_cascades, make_tight_cascades: any camera's points are in the cascade of their depth",
                   T, float, double) {
    std::mt19937 random(1);
    const bounding_box<T> scene{glm::vec<3, T>(-60, -20, -50), glm::vec<3, T>(70, 30, 55)};
    const glm::ivec2 size(512, 700);
    const T margin = 3;
    std::array<int, 4> tried{};
    for (const auto kind : cameras::all_kinds)
        for (const clip_space clip : all_clip_spaces()) {
            CAPTURE(to_string(kind));
            CAPTURE(to_string(clip));
            const auto c = cameras::of_kind(kind, cameras::random_view(random, 20, clip), clip);
            camera_matrices<T> matrices{
                glm::mat<4, 4, T>(c.view), glm::mat<4, 4, T>(c.projection), {}, T(0.5), T(60), clip};
            if (c.other_eye) matrices.other_eye = glm::mat<4, 4, T>(*c.other_eye);
            const cascade_fit<T> fit{.camera = make_frustum(matrices),
                                     .direction = glm::vec<3, T>(bodies::random_vector(random, -1, 1)),
                                     .scene = scene,
                                     .map_size = size,
                                     .margin = margin,
                                     .clip = clip};
            const auto splits = practical_splits<4>(T(0.5), T(60), T(0.7));
            const auto check = [&](const auto& cascades) {
                const auto u = make_cascade_uniforms(cascades, T(0));
                int outside = 0;
                for (int i = 0; i < 1200; ++i) {
                    const double depth = 0.5 * std::pow(120.0, bodies::real(0, 1)(random));
                    const glm::dmat4& eye = c.other_eye && i % 2 ? *c.other_eye : c.projection;
                    const glm::vec<3, T> p(cameras::seen_by(c, eye, depth, random));
                    if (glm::any(glm::lessThan(p, scene.low)) || glm::any(glm::greaterThan(p, scene.high))) continue;
                    const T number = cascade_by_depth(T(depth), u.ends);
                    const glm::vec<3, T> light(shadow_coordinate(u.rotation, p));
                    const glm::vec<3, T> at =
                        cascade_coordinate(light, cascade_column(u.scales, number), cascade_column(u.offsets, number));
                    outside += !inside_cascade(at, glm::vec<2, T>(size), margin - T(0.02));
                    ++tried[std::size_t(number)];
                }
                CHECK(outside == 0);
            };
            check(make_stable_cascades<4>(fit, splits));
            check(make_tight_cascades<4>(fit, splits));
        }
    for (const int of_cascade : tried) CHECK(of_cascade > 10000);
}

TEST_CASE("make_stable_cascades: any camera's texels stay on their grid while it moves and turns") {
    std::mt19937 random(2);
    for (const auto kind : cameras::all_kinds) {
        CAPTURE(to_string(kind));
        const auto of_view = [&](const glm::dmat4& view) {
            const cascade_fit<double> fit{.camera = make_frustum(cameras::of_kind(kind, view, vulkan_clip_space)),
                                          .direction = {0.3, -1, 0.4},
                                          .scene = bounding_box<double>{glm::dvec3(-99), glm::dvec3(99)},
                                          .map_size = {512, 256},
                                          .clip = vulkan_clip_space};
            return make_stable_cascades<2>(fit, std::array{0.5, 10.0, 60.0});
        };
        const auto first = of_view(glm::dmat4(1));
        for (int i = 0; i < 50; ++i) {
            const auto now = of_view(cameras::random_view(random, 50, vulkan_clip_space));
            for (std::size_t k = 0; k < 2; ++k) {
                CHECK(now[k].scale == first[k].scale);
                CHECK(8 * now[k].offset.z == std::round(8 * now[k].offset.z));
                for (glm::length_t axis = 0; axis < 2; ++axis)
                    CHECK(now[k].offset[axis] == std::round(now[k].offset[axis]));
            }
        }
    }
}
