// SPDX-License-Identifier: MIT
//
// Warps for cameras of every kind: they hold what each eye sees, and warp for no orthographic one.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "../../cameras.hpp"
#include "../../clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("warps: any camera's points of the scene are in the map") {
    std::mt19937 random(1);
    const bounding_box<double> scene{{-60, -20, -50}, {70, 30, 55}};
    int tried = 0;
    for (const auto kind : cameras::all_kinds)
        for (const clip_space clip : all_clip_spaces()) {
            CAPTURE(to_string(kind));
            CAPTURE(to_string(clip));
            const auto c = cameras::of_kind(kind, cameras::random_view(random, 20, clip), clip);
            const frustum<double> camera = make_frustum(c);
            const warp_fit<double> fit{.camera = camera,
                                       .direction = bodies::random_vector(random, -1, 1),
                                       .receivers = intersection(camera, scene),
                                       .casters = scene,
                                       .clip = clip};
            const auto psm = fit_perspective(fit);
            const std::vector<warped_light<double>> all{fit_light_space_perspective(fit), fit_trapezoidal(fit, 20.0),
                                                        psm};
            const bool shrinks = kind != cameras::kind::orthographic && kind != cameras::kind::oblique;
            if (!shrinks) CHECK(psm.seen_as == light_image::none);
            for (const auto& w : all) {
                if (!shrinks) CHECK(w.strength == 0);
                const glm::dmat4 m = texture_matrix(w.light, {1, 1});
                int outside = 0;
                for (int i = 0; i < 200; ++i) {
                    const glm::dmat4& eye = c.other_eye && i % 2 ? *c.other_eye : c.projection;
                    const glm::dvec3 p = cameras::seen_by(c, eye, bodies::real(0.5, 60)(random), random);
                    if (glm::any(glm::lessThan(p, scene.low)) || glm::any(glm::greaterThan(p, scene.high))) continue;
                    const glm::dvec3 at = project_coordinate(shadow_coordinate(m, p));
                    outside +=
                        glm::any(glm::lessThan(at, glm::dvec3(0))) || glm::any(glm::greaterThan(at, glm::dvec3(1)));
                    ++tried;
                }
                CHECK(outside == 0);
            }
        }
    CHECK(tried > 10000);
}

TEST_CASE("fit_plane_optimal: on the plane the map is the screen, off-axis and orthographic ones too") {
    std::mt19937 random(2);
    const glm::dvec4 ground(0, 1, 0, 5);
    int seen = 0;
    for (const auto kind : cameras::all_kinds)
        for (const clip_space clip : all_clip_spaces()) {
            CAPTURE(to_string(kind));
            CAPTURE(to_string(clip));
            const glm::dmat4 view =
                look_along(bodies::random_vector(random, 0, 4), {0.3, -0.5, -0.7}, {0, 1, 0}, clip.hand);
            const auto c = cameras::of_kind(kind, view, clip);
            const warp_fit<double> fit{
                .camera = make_frustum(c), .direction = {0.4, -1, 0.2}, .receivers = hull(), .margin = 0, .clip = clip};
            const auto map = fit_plane_optimal(fit, ground);
            REQUIRE(map.has_value());
            const glm::dmat4 to_map = map->light.projection * map->light.view;
            for (int i = 0; i < 400; ++i) {
                const glm::dvec3 p(bodies::random_vector(random, -40, 40) * glm::dvec3(1, 0, 1) - glm::dvec3(0, 5, 0));
                const double z = std::abs((view * glm::dvec4(p, 1)).z);
                const glm::dvec4 h = c.projection * view * glm::dvec4(p, 1), at = to_map * glm::dvec4(p, 1);
                if (z > 60 || z < 0.5 || std::abs(h.x) > h.w || std::abs(h.y) > h.w) continue;
                ++seen;
                const glm::dvec2 screen = glm::dvec2(h) / h.w, in_map = glm::dvec2(at) / at.w;
                if (c.other_eye) CHECK(std::max(std::abs(in_map.x), std::abs(in_map.y)) < 1);
                else CHECK(glm::length(glm::abs(in_map) - glm::abs(screen)) < 1e-10);
            }
        }
    CHECK(seen > 2000);
}
