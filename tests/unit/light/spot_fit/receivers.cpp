// SPDX-License-Identifier: MIT
//
// Spots fitted to receivers, against points taken at random and linear programmes.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/gtc/matrix_access.hpp>

#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

/// x and y from 0 to 1 over the map, and depth from 0 at the near plane.
glm::dvec3 placed(const light_space<double>& light, glm::dvec3 p) {
    glm::dvec3 at = through(texture_matrix(light, {1, 1}), p);
    if (light.clip.direction == depth_direction::reversed) at.z = 1.0 - at.z;
    return at;
}

bool holds(const light_space<double>& light, glm::dvec3 p) {
    const glm::dvec3 at = placed(light, p);
    constexpr double rounding = 1e-9;
    bool inside = true;
    for (int k = 0; k < 3; ++k) inside &= at[k] > -rounding && at[k] < 1 + rounding;
    return inside;
}

/// x, y to its sides and the distance along its axis.
glm::dvec3 seen_by(const light_space<double>& light, glm::dvec3 p) {
    return glm::dvec3(detail::light_frame(light.view, light.clip.hand) * glm::dvec4(p, 1));
}

struct scene {
    spot_fit<double> fit{.receivers = bounding_box<double>{}, .clip = cpu_clip_space};
    frustum<double> camera;
    bounding_box<double> floor, above;
    polyhedron seen;

    scene(std::mt19937& random, int i) {
        camera = bodies::random_frustum(random);
        floor = bodies::random_box(random, i % 5 == 0);
        fit.position = bodies::random_vector(random, -9, 9);
        fit.outer_angle_radians = bodies::real(0.3, 1.3)(random);
        fit.z_near = 0.2;
        seen = intersection(camera, floor);
        std::vector<glm::dvec3> points = hull(seen).points;
        const glm::dvec3 aim = seen.empty() ? glm::dvec3(0) : points[0];
        if (!seen.empty() && i % 3 == 0) {
            for (int k = 0; k < 20; ++k) points.push_back(bodies::point_between(points, random));
            std::shuffle(points.begin(), points.end(), random);
        }
        fit.receivers = points;
        fit.direction = aim - fit.position + bodies::random_vector(random, -3, 3);
        const glm::dvec3 half = bodies::random_vector(random, 0.1, 3);
        const glm::dvec3 middle = glm::mix(fit.position, aim, bodies::real(0.2, 0.9)(random));
        above = {middle - half, middle + half};
        if (i % 7 == 0) above = {fit.position - half, fit.position + half};  // the light is within
        fit.casters = above;
        fit.clip = all_clip_spaces()[std::size_t(i % 16)];
    }

    /// False where nothing is lit.
    bool make(light_space<double>& light) const {
        const auto fitted = fit_spot_light(fit);
        light = fitted.value_or(light);
        return fitted.has_value();
    }
};

}  // namespace

TEST_CASE("fit_spot_light: holds every receiver in the cone and every caster between it and the light") {
    std::mt19937 random(1);
    int received = 0, cast = 0, lost = 0;
    for (int i = 0; i < 500; ++i) {
        scene s(random, i);
        if (i % 2) s.fit.margin = 0;
        light_space<double> light;
        if (!s.make(light)) continue;
        const auto& corners = s.fit.receivers->points;
        for (int k = 0; k < 100; ++k) {
            const glm::dvec3 receiver = bodies::point_between(corners, random);
            const glm::dvec3 at = seen_by(light, receiver);
            const double edge = std::tan(s.fit.outer_angle_radians) * at.z;
            if (at.z < s.fit.z_near || std::abs(at.x) > edge || std::abs(at.y) > edge) continue;
            ++received;
            lost += !holds(light, receiver);
            for (int j = 0; j < 5; ++j) {
                const glm::dvec3 caster = glm::mix(s.fit.position, receiver, bodies::real(0, 1)(random));
                if (seen_by(light, caster).z < s.fit.z_near || glm::any(glm::lessThan(caster, s.above.low)) ||
                    glm::any(glm::greaterThan(caster, s.above.high)))
                    continue;
                ++cast;
                lost += !holds(light, caster);
            }
        }
    }
    CHECK(lost == 0);
    CHECK(received > 3000);
    CHECK(cast > 1000);
}

TEST_CASE("fit_spot_light: no larger than linear programmes over receivers, and over casters before them, say") {
    std::mt19937 random(2);
    int fitted = 0, pulled = 0, within = 0;
    for (int i = 0; i < 120; ++i) {
        scene s(random, i);
        s.fit.margin = 0;
        light_space<double> light;
        const bool made = s.make(light);
        if (!made)
            light =
                make_spot_light<double>({.position = s.fit.position, .direction = s.fit.direction, .clip = s.fit.clip});
        const glm::dmat4 frame = detail::light_frame(light.view, s.fit.clip.hand);
        const glm::dvec3 x(glm::row(frame, 0)), y(glm::row(frame, 1)), z(glm::row(frame, 2));
        const glm::dvec3 offset(frame[3]);
        const double edge = std::tan(s.fit.outer_angle_radians);
        const auto constraint = [&](glm::dvec3 a, double b) {
            const double length = glm::length(a);
            return bodies::programme<3>::constraint{{a.x / length, a.y / length, a.z / length}, b / length};
        };
        bodies::programme<3> lit;  // the receivers in the cone
        bodies::inside(lit, s.camera);
        bodies::inside(lit, s.floor);
        for (glm::dvec3 side : {x, -x, y, -y}) {
            const double shift = glm::dot(glm::dvec3(offset), glm::dvec3(glm::dot(side, x), glm::dot(side, y), 0));
            lit.constraints.push_back(constraint(side + edge * z, shift + edge * offset.z));
        }
        lit.constraints.push_back(constraint(z, offset.z - s.fit.z_near));
        const auto least_z = lit.least({z.x, z.y, z.z}), greatest_z = lit.least({-z.x, -z.y, -z.z});
        CHECK(made == least_z.has_value());
        if (!made) continue;
        ++fitted;
        double z_near = *least_z + offset.z;
        const double z_far = -*greatest_z + offset.z;

        // casters are the points of the box, beyond z_near, within all planes through the light and the outline
        bodies::programme<3> before;
        bodies::inside(before, s.above);
        before.constraints.push_back(constraint(z, offset.z - s.fit.z_near));
        auto points = detail::seen(
            frame,
            hull(intersection(frustum<double>{s.fit.position, s.fit.direction, s.fit.up, edge, edge, s.fit.z_near, 99},
                              s.seen))
                .points);
        for (glm::dvec3& p : points) p = {p.x / p.z, p.y / p.z, p.z};
        for (std::size_t k = 0; k < points.size(); ++k)
            for (std::size_t j = 0; j < points.size(); ++j) {
                const glm::dvec2 a(points[k]), b(points[j]), in(a.y - b.y, b.x - a.x);
                if (glm::length(in) < 1e-7) continue;
                bool is_outline = true;
                for (const glm::dvec3& p : points) is_outline &= glm::dot(in, glm::dvec2(p) - a) > -1e-12;
                if (!is_outline) continue;
                const double c = -glm::dot(in, a);
                const auto plane =
                    constraint(in.x * x + in.y * y + c * z, in.x * offset.x + in.y * offset.y + c * offset.z);
                if (std::none_of(before.constraints.begin(), before.constraints.end(), [&](const auto& other) {
                        return std::abs(other.b - plane.b) < 1e-6 && std::abs(other.a[0] - plane.a[0]) < 1e-6 &&
                               std::abs(other.a[1] - plane.a[1]) < 1e-6;
                    }))
                    before.constraints.push_back(plane);
            }
        const auto nearest = before.least({z.x, z.y, z.z});
        if (nearest && *nearest + offset.z < z_near) z_near = *nearest + offset.z, ++pulled;
        within += z_near < s.fit.z_near + 1e-9;

        const glm::dmat4 back = glm::inverse(light.projection * light.view);
        const bool reversed = s.fit.clip.direction == depth_direction::reversed;
        const double shallow = s.fit.clip.range == depth_range::zero_to_one ? 0 : -1;
        CHECK(seen_by(light, through(back, {0, 0, reversed ? 1 : shallow})).z == doctest::Approx(z_near).epsilon(1e-6));
        CHECK(seen_by(light, through(back, {0, 0, reversed ? shallow : 1})).z == doctest::Approx(z_far).epsilon(1e-6));
        glm::dvec2 low(2), high(-1);  // the map's sides are touched
        for (const glm::dvec3& p : points) {
            const glm::dvec3 world(glm::inverse(frame) * glm::dvec4(p.x * p.z, p.y * p.z, p.z, 1));
            low = glm::min(low, glm::dvec2(placed(light, world))),
            high = glm::max(high, glm::dvec2(placed(light, world)));
        }
        CHECK(glm::length(low) < 1e-9);
        CHECK(glm::length(high - 1.0) < 1e-9);
    }
    CHECK(fitted > 40);
    CHECK(pulled > 10);
    CHECK(within > 3);
}

TEST_CASE_TEMPLATE("fit_spot_light: what lies between points, none of which is in the cone; a sphere's box", T, float,
                   double) {
    const auto fitted = [](const hull& receivers) {
        const auto light = fit_spot_light<T>({.position = {0, 4, 0},
                                              .direction = {0, -1, 0},
                                              .up = {0, 0, 1},
                                              .outer_angle_radians = std::atan(T(0.5)),
                                              .receivers = receivers,
                                              .margin = 0,
                                              .clip = cpu_clip_space})
                               .value();
        return texture_matrix<double>({glm::dmat4(light.view), glm::dmat4(light.projection), light.clip}, {1, 1});
    };
    const glm::dmat4 strip =
        fitted(std::vector<glm::dvec3>{{-10, 0, -1}, {10, 0, -1}, {10, 1, 1}, {-10, 1, 1}, {0, 9, 0}});
    const auto at = [](const glm::dmat4& m, glm::dvec3 p) { return glm::abs(through(m, p) - 0.5) * 2.0; };
    CHECK(at(strip, {2, 0, -1}).x == doctest::Approx(1));  // the cone's side
    CHECK(through(strip, {0, 0, -1}).z == doctest::Approx(1));
    CHECK(through(strip, {0, 3.9, 0}).z == doctest::Approx(0).epsilon(1e-5));  // between the floor and what is above
    const glm::dmat4 ball = fitted(bounding_sphere<T>{glm::vec<3, T>(0, 0, 0), T(0.5)});
    CHECK(at(ball, {0.5, 0.5, 0.5}).x == doctest::Approx(1));
    CHECK(at(ball, {0.5, 0.5, 0.5}).y == doctest::Approx(1));
    CHECK(through(ball, {0, 3.9, 0}).z == doctest::Approx(0).epsilon(1e-5));  // at z_near: no caster is lost
    CHECK(through(ball, {0, -0.5, 0}).z == doctest::Approx(1));
}
