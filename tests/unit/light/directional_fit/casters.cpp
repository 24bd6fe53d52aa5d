// SPDX-License-Identifier: MIT
//
// Receivers and casters apart, against points taken at random and a linear programme that knows nothing of hulls.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/directional_fit.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

/// x, y and depth from 0 at the near plane to 1 at the far plane.
glm::dvec3 placed(const light_space<double>& light, glm::dvec3 p) {
    glm::dvec3 ndc = through(light.projection * light.view, p);
    if (light.clip.range == depth_range::minus_one_to_one) ndc.z = ndc.z * 0.5 + 0.5;
    if (light.clip.direction == depth_direction::reversed) ndc.z = 1.0 - ndc.z;
    return ndc;
}

bool holds(const light_space<double>& light, glm::dvec3 p) {
    const glm::dvec3 at = placed(light, p);
    constexpr double rounding = 1e-9;
    return std::abs(at.x) < 1 + rounding && std::abs(at.y) < 1 + rounding && at.z > -rounding && at.z < 1 + rounding;
}

/// A box of casters on the receivers' way to the light, or not far from it.
bounding_box<double> before(const polyhedron& receivers, glm::dvec3 direction, std::mt19937& random, bool flat) {
    const bounding_box<double> box = bodies::random_box(random, flat);
    const glm::dvec3 half = (box.high - box.low) * 0.5;
    const glm::dvec3 middle = hull(receivers).points[0] - direction * bodies::real(-2, 9)(random);
    return {middle - half, middle + half};
}

}  // namespace

TEST_CASE("fit_directional_light: holds every receiver and every caster on a receiver's way to the light") {
    std::mt19937 random(5);
    int cast = 0, lost = 0;
    for (int i = 0; i < 400; ++i) {
        const clip_space clip = all_clip_spaces()[std::size_t(i % 16)];
        const polyhedron seen = intersection(bodies::random_frustum(random), bodies::random_box(random));
        if (seen.empty()) continue;
        const glm::dvec3 direction = glm::normalize(bodies::random_vector(random, -1, 1));
        const bounding_box<double> above = before(seen, direction, random, false);
        const auto light = fit_directional_light<double>({.direction = direction,
                                                          .receivers = seen,
                                                          .casters = above,
                                                          .margin = i % 3 ? 0.0 : 0.01,
                                                          .snap_texels = glm::ivec2(i % 4 ? 0 : 256),
                                                          .clip = clip});
        const std::vector<glm::dvec3> corners = hull(seen).points;
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 receiver = bodies::point_between(corners, random);
            lost += !holds(light, receiver);
            const glm::dvec3 caster = receiver - direction * bodies::real(0, 20)(random);
            if (glm::any(glm::lessThan(caster, above.low)) || glm::any(glm::greaterThan(caster, above.high))) continue;
            ++cast;
            lost += !holds(light, caster);
        }
    }
    CHECK(lost == 0);
    CHECK(cast > 2000);
}

TEST_CASE("fit_directional_light: no larger than linear programmes over receivers and casters say it has to be") {
    std::mt19937 random(6);
    int pulled = 0, kept = 0;
    for (int i = 0; i < 200; ++i) {
        const clip_space clip = all_clip_spaces()[std::size_t(i % 16)];
        const bounding_box<double> scene = bodies::random_box(random);
        const frustum<double> camera = bodies::random_frustum(random);
        const glm::dvec3 direction = glm::normalize(bodies::random_vector(random, -1, 1));
        const polyhedron seen = intersection(camera, scene);
        if (seen.empty()) continue;
        const bounding_box<double> above = before(seen, direction, random, i % 6 == 0);
        const auto light = fit_directional_light<double>(
            {.direction = direction, .receivers = seen, .casters = above, .margin = 0, .clip = clip});

        bodies::programme<3> receivers;
        bodies::inside(receivers, camera);
        bodies::inside(receivers, scene);
        const glm::dmat4 frame = detail::light_frame(light.view, clip.hand);
        glm::dvec3 low, high;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 row(frame[0][k], frame[1][k], frame[2][k]);
            low[k] = receivers.least({row.x, row.y, row.z}).value();
            high[k] = -receivers.least({-row.x, -row.y, -row.z}).value();
        }
        // a caster over the map's rectangle
        bodies::programme<3> casters;
        bodies::inside(casters, above);
        for (int k = 0; k < 2; ++k) {
            const double x = frame[0][k], y = frame[1][k], z = frame[2][k];
            casters.constraints.push_back({{x, y, z}, -low[k]});
            casters.constraints.push_back({{-x, -y, -z}, high[k]});
        }
        const std::optional<double> nearest = casters.least({direction.x, direction.y, direction.z});
        if (nearest && *nearest < low.z) low.z = *nearest, ++pulled;
        else ++kept;

        const glm::dmat4 back = glm::inverse(frame);
        const auto corner = [&](glm::dvec3 p) { return placed(light, glm::dvec3(back * glm::dvec4(p, 1))); };
        CHECK(glm::length(corner(low) - glm::dvec3(-1, -1, 0)) < 1e-7);
        CHECK(glm::length(corner(high) - glm::dvec3(1, 1, 1)) < 1e-7);
    }
    CHECK(pulled > 20);
    CHECK(kept > 5);
}

TEST_CASE("fit_directional_light: points as receivers give what their hull's corners do; a sphere its diameter") {
    std::mt19937 random(7);
    for (clip_space clip : all_clip_spaces()) {
        const bounding_box<double> above = bodies::random_box(random);
        const glm::dvec3 direction = bodies::random_vector(random, -1, 1);
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 30; ++i) points.push_back(bodies::random_vector(random, -3, 3));
        const auto fitted = [&](const hull& receivers) {
            return fit_directional_light<double>(
                {.direction = direction, .receivers = receivers, .casters = above, .margin = 0, .clip = clip});
        };
        const auto light = fitted(points);
        glm::dvec3 low(9), high(-9);
        for (const glm::dvec3& p : points) {
            low = glm::min(low, placed(light, p)), high = glm::max(high, placed(light, p));
            CHECK(holds(light, p));
        }
        CHECK(glm::length(glm::dvec2(low) + 1.0) < 1e-12);
        CHECK(glm::length(high - 1.0) < 1e-12);
        for (int i = 0; i < 100; ++i)
            points.push_back(bodies::point_between(points, random));  // what lies within changes nothing
        CHECK(difference(fitted(points).projection, light.projection) < 1e-12);

        const bounding_sphere<double> sphere{bodies::random_vector(random, -3, 3), 2.5};
        const auto around = fitted(sphere);
        for (int i = 0; i < 100; ++i)
            CHECK(holds(around, sphere.center + 2.5 * glm::normalize(bodies::random_vector(random, -1, 1))));
        CHECK(around.projection[0][0] == doctest::Approx(1 / 2.5));
        CHECK(around.projection[1][1] == doctest::Approx(1 / 2.5));
    }
}

TEST_CASE("fit_directional_light: a camera that looks along the light, against it, and from within a caster") {
    const bounding_box<double> scene{{-10, -10, -10}, {10, 10, 10}};
    for (clip_space clip : all_clip_spaces())
        for (double sign : {1.0, -1.0}) {
            const glm::dvec3 direction(0.3, -0.9, 0.2);
            const frustum<double> camera{.position = {1, 2, 3}, .direction = sign * direction, .z_far = 40};
            const polyhedron seen = intersection(camera, scene);
            const bounding_box<double> around{{0, 1, 2}, {2, 3, 4}};  // the camera
            const auto light = fit_directional_light<double>(
                {.direction = direction, .receivers = seen, .casters = around, .clip = clip});
            for (const glm::dvec3& p : hull(seen).points) CHECK(holds(light, p));
            CHECK(detail::all_finite(light.projection * light.view));
        }
}
