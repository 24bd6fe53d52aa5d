// SPDX-License-Identifier: MIT
//
// Cameras that move: the texels of a snapped map stay where they are in the world.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

constexpr double center_of_scene = 3000;

/// Along a curve through the scene's middle, looking all around.
frustum<double> camera_at(int i) {
    const double t = 0.013 * i;
    return {.position = {center_of_scene + 20 * std::cos(t), 2, center_of_scene + 17 * std::sin(1.7 * t)},
            .direction = {std::sin(5 * t), -0.2 * std::sin(t), std::cos(5 * t)},
            .tan_half_x = 1.02,
            .tan_half_y = 0.577,
            .z_near = 0.5,
            .z_far = 27};
}

glm::dmat4 matrix(const hull& receivers, clip_space clip, double margin = 0, glm::ivec2 size = {1024, 1024}) {
    const bounding_box<double> scene{{center_of_scene - 60, 0, center_of_scene - 60},
                                     {center_of_scene + 60, 10, center_of_scene + 60}};
    return texture_matrix(fit_directional_light<double>({.direction = {0.4, -0.8, 0.3},
                                                         .receivers = receivers,
                                                         .casters = scene,
                                                         .margin = margin,
                                                         .snap_texels = size,
                                                         .clip = clip}),
                          size);
}

double off_grid(double texels) { return std::abs(texels - std::round(texels)); }

}  // namespace

TEST_CASE("fit_directional_light: around a sphere, snapped, texels move by whole ones; float keeps to a hundredth") {
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const int wide = clip.hand == handedness::right ? 1024 : 512;
        const glm::ivec2 size(wide, clip.range == depth_range::zero_to_one ? 1024 : 640);
        const glm::dmat4 before = matrix(sphere_around(camera_at(0)), clip, 0, size);
        const glm::dmat3 rows = glm::transpose(glm::dmat3(before));
        CHECK(glm::length(rows[0]) == doctest::Approx(glm::length(rows[1])).epsilon(1e-12));  // texels are squares
        double drift = 0, float_drift = 0, wobble = 0;
        int moves = 0, outside = 0;
        for (int i = 1; i < 300; ++i) {
            const auto camera = camera_at(i);
            const glm::dmat4 now = matrix(sphere_around(camera), clip, 0, size);
            for (int row = 0; row < 2; ++row) {
                for (int k = 0; k < 3; ++k) wobble = std::max(wobble, std::abs(now[k][row] - before[k][row]));
                drift = std::max(drift, off_grid(now[3][row] - before[3][row]));
                moves += now[3][row] != before[3][row];
            }
            const glm::mat4 single(now), single_before(before);
            for (const glm::dvec3& p : corners(camera)) {
                const glm::dvec3 at = through(now, p);
                outside += !(std::min({at.x, at.y, at.z}) >= 0 && at.x <= size.x && at.y <= size.y && at.z <= 1);
                const glm::dvec3 moved = through(single, p) - through(single_before, p);
                float_drift = std::max({float_drift, off_grid(moved.x), off_grid(moved.y)});
            }
        }
        CHECK(wobble == 0);
        CHECK(drift < 1e-9);
        CHECK(float_drift < 0.01);
        CHECK(moves > 300);
        CHECK(outside == 0);
    }
}

TEST_CASE("fit_directional_light: around a sphere, snapped, depth stays to the bit while the scene's box holds it") {
    const auto at = [](double x) {
        return matrix(bounding_sphere<double>{{center_of_scene + x, 5, center_of_scene}, 4}, cpu_clip_space, 0.01);
    };
    const glm::dmat4 before = at(0);
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 4; ++k) CHECK(at(0.37 * i)[k][2] == before[k][2]);
}

TEST_CASE("fit_directional_light: without snapping the grid drifts") {
    const auto at = [](double x) {
        return texture_matrix(
            fit_directional_light<double>({.direction = {0.4, -0.8, 0.3},
                                           .receivers = bounding_sphere<double>{{center_of_scene + x, 5, 0}, 4},
                                           .clip = cpu_clip_space}),
            {1024, 1024});
    };
    double drift = 0;
    for (int i = 1; i < 100; ++i) drift = std::max(drift, off_grid(at(0.37 * i)[3][0] - at(0)[3][0]));
    CHECK(drift > 0.4);
}
