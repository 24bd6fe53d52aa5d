// SPDX-License-Identifier: MIT
//
// Warps of point lights: wherever one stands, before the camera, behind it or abreast.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>

#include "../bodies.hpp"
#include "../clip_spaces.hpp"

using namespace umbrage;

namespace {

const bounding_box<double> room{{-10, 0, -10}, {10, 5, 10}};

struct lamp_setting {
    warp_fit<double> fit{.receivers = bounding_box<double>{}, .clip = cpu_clip_space};
    light_position<double> from;
};

/// A camera in a room and a lamp, inside of it or not, that lights what the camera sees in a cone about its axis.
lamp_setting random_lamp(std::mt19937& random, int number) {
    lamp_setting s{.fit = {.casters = room, .clip = all_clip_spaces()[std::size_t(number % 16)]}, .from = {}};
    s.fit.camera = {.position = bodies::random_vector(random, -1, 1) * glm::dvec3(9, 2, 9) + glm::dvec3(0, 2.5, 0),
                    .direction = bodies::random_vector(random, -1, 1) * glm::dvec3(1, 0.3, 1),
                    .tan_half_x = 0.8,
                    .tan_half_y = 0.5,
                    .z_near = 0.2,
                    .z_far = 25};
    s.from.position = bodies::random_vector(random, -1, 1) * glm::dvec3(14, 3, 14) + glm::dvec3(0, 4, 0);
    s.from.z_near = bodies::real(0.05, 0.3)(random);
    const glm::dvec3 target =
        s.fit.camera.position + glm::normalize(s.fit.camera.direction) * bodies::real(2, 8)(random);
    s.fit.direction = target - s.from.position;
    const frustum<double> cone{.position = s.from.position,
                               .direction = s.fit.direction,
                               .tan_half_x = 0.7,
                               .tan_half_y = 0.7,
                               .z_near = s.from.z_near * 2,
                               .z_far = 60};
    s.fit.receivers = intersection(intersection(s.fit.camera, room), cone);
    s.fit.margin = number % 3 ? 0 : 0.02;
    if (number % 5 == 0) s.fit.casters.reset();  // all from z_near on
    return s;
}

/// Texels of a map of 2048 x 2048, and depth that runs forward.
glm::dvec3 on_map(const glm::dmat4& m, glm::dvec3 p, clip_space clip) {
    return in_convention(through(m, p), clip, 2048);
}

}  // namespace

TEST_CASE("fit_perspective, fit_plane_optimal: rays of a lamp are texels, depth grows along them, float holds them") {
    std::mt19937 random(5);
    int images[4]{}, lost = 0, bent = 0, disordered = 0, cast = 0, mirrored = 0;
    double rounded_texels = 0;
    for (int i = 0; i < 1200; ++i) {
        const lamp_setting s = random_lamp(random, i);
        if (s.fit.receivers->points.empty()) continue;
        const bool is_plane = i % 4 == 0;
        const auto warped = is_plane ? perspective_light<double>{} : fit_perspective(s.fit, s.from);
        light_space<double> light = warped.light;
        if (is_plane) {
            const glm::dvec4 floor(0, 1, 0, 0);
            const auto ground = fit_plane_optimal(s.fit, floor, s.from);
            CHECK(ground.has_value() == !detail::crossings(s.fit.camera, floor).empty());
            if (!ground) continue;
            light = ground->light;
        } else ++images[int(warped.seen_as)];
        const glm::dmat4 exact = texture_matrix(light, {2048, 2048}), rounded{glm::mat4(exact)};
        const auto place = [&](glm::dvec3 p) { return on_map(exact, p, s.fit.clip); };
        const auto inside = [&](glm::dvec3 at) {
            return at.x > -1e-6 && at.x < 2048 + 1e-6 && at.y > -1e-6 && at.y < 2048 + 1e-6 && at.z > -1e-9 &&
                   at.z < 1 + 1e-9;
        };
        const glm::dvec3 axis = glm::normalize(s.fit.direction);
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 receiver = bodies::point_between(s.fit.receivers->points, random);
            const glm::dvec3 at = place(receiver), back = s.from.position - receiver;
            const double w = (exact * glm::dvec4(receiver, 1)).w;
            if (is_plane && !(w > 0 && inside(at))) continue;
            lost += !(w > 0 && inside(at));
            const glm::dvec3 off = on_map(rounded, receiver, s.fit.clip) - at;
            rounded_texels = std::max({rounded_texels, std::abs(off.x), std::abs(off.y)});
            double depth = at.z;
            for (const double share : {0.3, 0.6, 0.99}) {
                const glm::dvec3 caster = receiver + share * back;
                const bool in_room = glm::all(glm::greaterThanEqual(caster, room.low)) &&
                                     glm::all(glm::lessThanEqual(caster, room.high));
                if (s.fit.casters && !in_room) continue;
                if (glm::dot(caster - s.from.position, axis) < s.from.z_near) continue;
                const glm::dvec3 own = place(caster);
                ++cast;
                lost += !(own.z > -1e-9);
                disordered += !(own.z < depth);
                bent += !(glm::length(glm::dvec2(own) - glm::dvec2(at)) < 1e-6);
                depth = own.z;
            }
        }
        const auto turn = [&](const light_space<double>& of, glm::dvec3 p) {
            const glm::dmat4 m = texture_matrix(of, {1, 1});
            const auto [x, y] = umbrage::detail::across(glm::normalize(p - s.from.position));
            const glm::dvec2 here(through(m, p)), a = glm::dvec2(through(m, p + 1e-3 * x)) - here,
                                                  b = glm::dvec2(through(m, p + 1e-3 * y)) - here;
            return a.x * b.y > a.y * b.x;
        };
        const auto spot =
            make_spot_light<double>({.position = s.from.position, .direction = s.fit.direction, .clip = s.fit.clip});
        const glm::dvec3 seen = s.fit.receivers->points[0];
        if (!is_plane) mirrored += turn(light, seen) != turn(spot, seen);
    }
    CHECK(lost == 0);
    CHECK(bent == 0);
    CHECK(disordered == 0);
    CHECK(mirrored == 0);
    CHECK(cast > 2000);
    CHECK(rounded_texels <= 0.004);
    CHECK(images[int(light_image::source)] > 100);
    CHECK(images[int(light_image::sink)] > 100);
    CHECK(images[int(light_image::none)] > 10);
}

TEST_CASE_TEMPLATE("lamps: bad input, and what warps of directional lights refuse", T, float, double) {
    using vec3 = glm::vec<3, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    const auto with = [](auto change) {
        return complaint([&] {
            warp_fit<T> fit{.camera = {.position = {0, 1, 4}},
                            .direction = {0, -1, 0},
                            .receivers = bounding_box<T>{},
                            .casters = bounding_box<T>{},
                            .clip = cpu_clip_space};
            light_position<T> from{.position = {T(0.1), 3, 0}};
            change(fit, from);
            for (const auto& light :
                 {fit_perspective(fit, from).light, fit_plane_optimal(fit, {0, 1, 0, T(0.5)}, from).value().light})
                CHECK(umbrage::detail::all_finite(light.projection * light.view));
        });
    };
    const std::string name = "umbrage::fit_perspective: ";
    CHECK(with([](auto&, auto&) {}) == "");
    CHECK(with([](auto& f, auto&) { f.receivers = hull(); }) == "");
    CHECK(with([](auto&, auto& l) { l.position.y = T(1.2); }) == "");
    CHECK(with([](auto&, auto& l) { l.position.y = T(1.05); }).starts_with(name + "receivers "));
    CHECK(with([](auto& f, auto&) { f.direction = -f.direction; }).starts_with(name + "receivers "));
    CHECK(with([](auto& f, auto&) { f.direction = {}; }).starts_with(name + "direction "));
    CHECK(with([&](auto&, auto& l) { l.position = vec3(nan); }).starts_with(name + "from.position "));
    for (const T bad : {T(0), T(-1), nan})
        CHECK(with([&](auto&, auto& l) { l.z_near = bad; }).starts_with(name + "from.z_near "));
}
