// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <common/quality.hpp>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "bodies.hpp"
#include "clip_spaces.hpp"
#include "reference_view.hpp"

using namespace umbrage;
using namespace reference_view;

TEST_CASE("longest_extent: of turned and stretched squares, and against a search over directions") {
    CHECK(longest_extent(glm::mat2(3, 0, 0, 2)) == 3);
    CHECK(longest_extent(glm::mat2(0, 2, -2, 0)) == 2);
    CHECK(longest_extent(glm::mat2(0, 0, 5, 0)) == 5);
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        glm::dmat2 m(1);
        for (int c = 0; c < 2; ++c)
            for (int r = 0; r < 2; ++r) m[c][r] = bodies::real(-3, 3)(random);
        double longest = 0;
        for (int k = 0; k < 3600; ++k) {
            const double turn = k * std::numbers::pi / 3600;
            longest = std::max(longest, glm::length(m * glm::dvec2(std::cos(turn), std::sin(turn))));
        }
        CHECK(longest_extent(m) == doctest::Approx(longest).epsilon(1e-6));
    }
}

TEST_CASE("pixels_per_texel: finite differences over the plane, directional and spot, in every convention") {
    std::mt19937 random(2);
    int some = 0;
    for (int i = 0; i < 400; ++i) {
        const clip_space clip = all_clip_spaces()[std::size_t(i % 16)];
        const glm::dvec3 p = bodies::random_vector(random, -1, 1), normal = bodies::random_vector(random, -1, 1);
        const glm::dvec3 light = bodies::random_vector(random, -4, 4), eye = bodies::random_vector(random, -4, 4);
        const glm::dvec3 n = glm::normalize(normal);
        if (std::abs(glm::dot(n, glm::normalize(light - p))) < 0.1 ||
            std::abs(glm::dot(n, glm::normalize(eye - p))) < 0.1)
            continue;
        if (glm::length(light - p) < 1 || glm::length(eye - p) < 1) continue;
        ++some;
        const glm::dmat4 texels =
            i % 2 ? texture_matrix(make_spot_light<double>({.position = light, .direction = -light, .clip = clip}),
                                   map_size)
                  : texture_matrix(fit_directional_light<double>(
                                       {.direction = p - light, .receivers = bounding_box<double>{}, .clip = clip}),
                                   map_size);
        const glm::dmat4 pixels =
            texture_matrix(make_spot_light<double>({.position = eye, .direction = p - eye, .clip = clip}), screen);
        const glm::dmat2 found = pixels_per_texel(texels, pixels, p, normal);
        const glm::dvec3 side = glm::normalize(glm::cross(n, glm::dvec3(0.3, 0.5, 0.8))), up = glm::cross(n, side);
        for (glm::dvec3 way : {side, up}) {
            const double h = 1e-5;
            const glm::dvec2 texel_step(through(texels, p + h * way) - through(texels, p - h * way));
            const glm::dvec2 pixel_step(through(pixels, p + h * way) - through(pixels, p - h * way));
            CHECK(glm::length(found * texel_step - pixel_step) < 1e-6 * glm::length(pixel_step));
        }
    }
    CHECK(some > 100);
}

TEST_CASE("pixels_per_texel: not finite where a surface is parallel to the light") {
    const glm::dmat4 texels =
        texture_matrix(fit_directional_light<double>(
                           {.direction = {0, -1, 0}, .receivers = bounding_box<double>{}, .clip = cpu_clip_space}),
                       map_size);
    const auto extent = [&](glm::dvec3 normal) {
        return longest_extent(pixels_per_texel(texels, reference.to_pixels, {0, 0, -5}, normal));
    };
    CHECK(is_finite(extent({0, 1, 0})));
    CHECK_FALSE(is_finite(extent({1, 0, 0})));
}

TEST_CASE("pixels_per_texel: one map around what a camera sees of a long ground, for suns all around") {
    struct row {
        double elevation, azimuth, p95, greatest;
    };
    // of an implementation apart from this one, by finite differences
    for (const row& r : {row{90, 0, 116, 143}, row{45, 90, 116, 143}, row{20, 90, 117, 144}, row{45, 180, 116, 143},
                         row{45, 0, 116, 143}, row{45, 135, 132, 186}, row{15, 180, 117, 145}, row{15, 0, 117, 144}}) {
        CAPTURE(r.elevation);
        CAPTURE(r.azimuth);
        const auto light = fit_directional_light<double>({.direction = sun(r.elevation, r.azimuth),
                                                          .up = reference.seen.direction,
                                                          .receivers = intersection(reference.seen, reference_scene),
                                                          .casters = reference_scene,
                                                          .margin = 0,
                                                          .clip = cpu_clip_space});
        const example::quality_report report = on_ground({texture_matrix(light, map_size)});
        CHECK(report.p95 == doctest::Approx(r.p95).epsilon(0.01));
        CHECK(report.greatest == doctest::Approx(r.greatest).epsilon(0.01));
        if (r.elevation < 90) continue;
        CHECK(report.mean == doctest::Approx(59.6).epsilon(0.01));
        CHECK(report.storage_factor == doctest::Approx(49473).epsilon(0.05));
    }
}

TEST_CASE("pixels_per_texel: four spheres and four tight cascades over the same ground and suns") {
    struct row {
        double elevation, azimuth, sphere_p95, sphere_greatest, tight_p95, tight_greatest;
    };
    const double step = std::pow(1000.0, 0.25);
    const std::array splits{0.5, step, step * step, step * step * step, 1000.0};
    // of an implementation apart from this one, by finite differences
    for (const row& r : {row{90, 0, 8.79, 11.6, 6.65, 7.53}, row{45, 90, 11.4, 14.1, 7.60, 8.53},
                         row{20, 90, 22.1, 24.8, 9.31, 10.3}, row{45, 180, 10.3, 14.5, 6.80, 8.03},
                         row{45, 0, 10.3, 14.5, 6.72, 7.78}, row{45, 135, 10.9, 16.4, 8.01, 11.5},
                         row{15, 180, 22.8, 34.3, 7.49, 9.99}, row{15, 0, 22.8, 34.3, 7.20, 9.33}}) {
        CAPTURE(r.elevation);
        CAPTURE(r.azimuth);
        cascade_fit<double> fit{.camera = reference.seen,
                                .direction = sun(r.elevation, r.azimuth),
                                .scene = reference_scene,
                                .margin = 0,
                                .clip = cpu_clip_space};
        const auto over = [&](const auto& cascades) {
            std::vector<glm::dmat4> to_texels;
            for (const auto& c : cascades) to_texels.push_back(texture_matrix(c.light, {1024, 1024}));
            return on_ground(to_texels, {1024, 1024}, {splits[1], splits[2], splits[3]});
        };
        const example::quality_report sphere = over(make_stable_cascades<4>(fit, splits));
        fit.up = reference.seen.direction;
        const example::quality_report tight = over(make_tight_cascades<4>(fit, splits));
        CHECK(sphere.p95 == doctest::Approx(r.sphere_p95).epsilon(0.01));
        CHECK(sphere.greatest == doctest::Approx(r.sphere_greatest).epsilon(0.01));
        CHECK(tight.p95 == doctest::Approx(r.tight_p95).epsilon(0.01));
        CHECK(tight.greatest == doctest::Approx(r.tight_greatest).epsilon(0.01));
        if (r.elevation < 90) continue;
        CHECK(sphere.mean == doctest::Approx(4.16).epsilon(0.01));
        CHECK(sphere.storage_factor == doctest::Approx(315).epsilon(0.05));
        CHECK(tight.mean == doctest::Approx(3.19).epsilon(0.01));
        CHECK(tight.storage_factor == doctest::Approx(96).epsilon(0.05));
    }
}

TEST_CASE(
    "pixels_per_texel: overhead light and bare frusta need the storage that theory says, in one map and in parts") {
    // of surfaces halfway between light and camera, on its axis: parts ratio (ratio - 1) / (2 tangent), ratio from
    // each part's near plane to its far plane
    struct row {
        double z_far;
        int parts;
        double storage_factor;
    };
    for (const row& r : {row{50, 1, 1225}, row{1000, 1, 499500}, row{1000, 2, 968}, row{1000, 3, 135}, row{1000, 4, 52},
                         row{1000, 8, 13}}) {
        CAPTURE(r.parts);
        const double ratio = std::pow(r.z_far, 1.0 / r.parts);
        const frustum<double> whole{.tan_half_x = 1, .tan_half_y = 1, .z_near = 1, .z_far = r.z_far};
        std::vector<glm::dmat4> to_texels;
        for (int i = 0; i < r.parts; ++i) {
            frustum<double> part = whole;
            part.z_near = std::pow(ratio, i), part.z_far = part.z_near * ratio;
            to_texels.push_back(texture_matrix(fit_directional_light<double>({.direction = {0, -1, 0},
                                                                              .up = {0, 0, -1},
                                                                              .receivers = part,
                                                                              .margin = 0,
                                                                              .clip = cpu_clip_space}),
                                               map_size));
        }
        const glm::dmat4 pixels = view(whole).to_pixels;
        const auto report =
            example::measure_quality({.screen = screen, .map_size = map_size, .maps = r.parts}, [&](glm::ivec2 p) {
                if (p.y != 0) return glm::dmat2(0);
                const double at = r.parts * p.x / 1279.0;
                const auto part = static_cast<std::size_t>(std::min(at, r.parts - 1.0));
                return pixels_per_texel(to_texels[part], pixels, glm::dvec3(0, 0, -std::pow(ratio, at)),
                                        glm::dvec3(0, 1, 1));
            });
        CHECK(report.storage_factor == doctest::Approx(r.storage_factor).epsilon(0.05));
    }
}
