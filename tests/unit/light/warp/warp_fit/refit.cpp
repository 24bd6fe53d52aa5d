// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

#include "../../bodies.hpp"
#include "../../clip_spaces.hpp"

using namespace umbrage;

namespace {

/// A random warp along a random way across the light, w = 1 at the first of the receivers.
glm::dmat4 any_warp(const warp_fit<double>& fit, std::mt19937& random) {
    const glm::dmat4 frame = detail::light_frame(detail::view_of(fit, "any_warp"), fit.clip.hand);
    const double turn = bodies::real(0, 6)(random), strength = bodies::real(0, 3)(random);
    glm::dvec4 w(std::cos(turn), std::sin(turn), 0, 0);
    double least = 1e9;
    for (const glm::dvec3& p : detail::seen(frame, fit.receivers->points))
        least = std::min(least, glm::dot(w, glm::dvec4(p, 1)));
    w = strength * (w - glm::dvec4(0, 0, 0, least)) + glm::dvec4(0, 0, 0, 1);
    glm::dmat4 warp(1);
    for (int i = 0; i < 4; ++i) warp[i][3] = w[i];
    return warp * frame;
}

/// x, y and depth of a forward map of [0, 1].
glm::dvec3 in_cube(const light_space<double>& light, glm::dvec3 p) {
    return in_convention(through(texture_matrix(light, {1, 1}), p), light.clip, 1);
}

}  // namespace

TEST_CASE("refit: receivers touch all sides of the map, swept casters lie in it, in every convention") {
    std::mt19937 random(1);
    int cast = 0, lost = 0, pulled = 0;
    for (int i = 0; i < 200; ++i) {
        const clip_space clip = all_clip_spaces()[std::size_t(i % 16)];
        const bounding_box<double> box = bodies::random_box(random);
        const polyhedron seen = intersection(bodies::random_frustum(random), box);
        if (seen.empty()) continue;
        const glm::dvec3 direction = glm::normalize(bodies::random_vector(random, -1, 1));
        bounding_box<double> above = bodies::random_box(random);
        above.low -= direction * 3.0, above.high -= direction * 3.0;
        const warp_fit<double> fit{.camera = bodies::random_frustum(random),
                                   .direction = direction,
                                   .receivers = seen,
                                   .casters = above,
                                   .margin = i % 2 ? 0 : 0.01,
                                   .clip = clip};
        const auto warped = detail::refit(any_warp(fit, random), fit, "refit");
        REQUIRE(warped.has_value());
        glm::dvec3 low(1e9), high(-1e9);
        double least_w = 1e9, greatest_w = 0;
        for (const glm::dvec3& p : fit.receivers->points) {
            const glm::dvec3 at = in_cube(warped->light, p);
            const double w = (warped->light.projection * warped->light.view * glm::dvec4(p, 1)).w;
            low = glm::min(low, at), high = glm::max(high, at);
            least_w = std::min(least_w, w), greatest_w = std::max(greatest_w, w);
        }
        const double edge = fit.margin / (1 + 2 * fit.margin);
        for (int k = 0; k < 2; ++k) {
            CHECK(low[k] == doctest::Approx(edge));
            CHECK(high[k] == doctest::Approx(1 - edge));
        }
        CHECK((low.z > -1e-12 && high.z < 1 + 1e-12));
        if (fit.margin == 0) CHECK(high.z == doctest::Approx(1));
        pulled += low.z > 0.1;
        CHECK(least_w == doctest::Approx(1));
        CHECK(warped->strength == doctest::Approx(1 - least_w / greatest_w));
        for (int k = 0; k < 100; ++k) {
            const glm::dvec3 receiver = bodies::point_between(fit.receivers->points, random);
            const glm::dvec3 caster = receiver - direction * bodies::real(0, 20)(random);
            if (glm::any(glm::lessThan(caster, above.low)) || glm::any(glm::greaterThan(caster, above.high))) continue;
            ++cast;
            const glm::dvec3 at = in_cube(warped->light, caster), own = in_cube(warped->light, receiver);
            lost += !(at.z > -1e-9 && at.z <= own.z);
            lost += !(glm::length(glm::dvec2(at) - glm::dvec2(own)) < 1e-9);
        }
    }
    CHECK(lost == 0);
    CHECK(cast > 200);
    CHECK(pulled > 20);
}

TEST_CASE("refit: turns a mirrored map over") {
    for (const clip_space clip : all_clip_spaces()) {
        const warp_fit<double> fit{.direction = {1, -2, 0.5}, .receivers = bounding_box<double>{}, .clip = clip};
        const glm::dmat4 frame = detail::light_frame(detail::view_of(fit, "refit"), clip.hand);
        glm::dmat4 mirror(1);
        mirror[0][0] = -1;
        const auto straight = detail::refit(frame, fit, "refit"),
                   mirrored = detail::refit(mirror * frame, fit, "refit");
        const auto uniform = fit_directional_light<double>(
            {.direction = fit.direction, .up = {0, 0, -1}, .receivers = bounding_box<double>{}, .clip = clip});
        const auto turn = [](const light_space<double>& light) {
            return glm::determinant(light.projection * light.view) < 0;
        };
        CHECK(difference(straight->light.projection, mirrored->light.projection) < 1e-15);
        CHECK(turn(straight->light) == turn(uniform));
        CHECK(straight->strength == 0);
    }
}

TEST_CASE("refit: nothing for receivers behind w = 0 or of no extent; a ball's box stands for it") {
    warp_fit<double> fit{.direction = {0, -1, 0}, .receivers = bounding_box<double>{}, .clip = cpu_clip_space};
    glm::dmat4 map = detail::light_frame(detail::view_of(fit, "refit"), fit.clip.hand);
    CHECK(detail::refit(map, fit, "refit").has_value());
    map[0][3] = 2;
    CHECK(!detail::refit(map, fit, "refit").has_value());
    map[0][3] = 0.5;
    CHECK(detail::refit(map, fit, "refit").has_value());
    fit.receivers = bounding_box<double>{{1, 1, 1}, {1, 1, 1}};
    CHECK(!detail::refit(map, fit, "refit").has_value());
    CHECK(
        complaint([&] { (void)detail::unwarped(fit, "f"); }).starts_with("umbrage::f: receivers, casters and margin"));
    fit.receivers = bounding_sphere<double>{{1, 2, 3}, 0.5};
    const auto ball = detail::refit(map, fit, "refit");
    fit.receivers = bounding_box<double>{{0.5, 1.5, 2.5}, {1.5, 2.5, 3.5}};
    CHECK(difference(ball->light.projection, detail::refit(map, fit, "refit")->light.projection) < 1e-15);
    fit.receivers = bounding_box<double>{{-1, -1, 2}, {1, 1, 2}};  // edge on
    CHECK(detail::refit(map, fit, "refit").has_value());
}
