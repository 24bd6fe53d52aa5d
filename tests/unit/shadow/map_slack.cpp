// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>

#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/shadow/map_slack.hpp>
#include <umbrage/shadow/single_map.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("map_slack: a plane's slack in texels of slope has the rasterizer's grid, the map's size and grazing light") {
    clip_space clip = cpu_clip_space;
    clip.subpixel_bits = 8;
    CHECK(detail::texels_beside_plane(clip, {1024, 512}) == 2.0 / 256 + 0x1p-11 + 0.125);
    clip.subpixel_bits = 4;
    CHECK(detail::texels_beside_plane(clip, {256, 2048}) == 2.0 / 16 + 0x1p-10 + 0.125);
}

TEST_CASE("map_slack: units of a map are those of its light, also relative to an anchor") {
    for (const light_space<double>& light : {detail::in_double(shadow_scene::spot(cpu_clip_space)),
                                             detail::in_double(shadow_scene::fitted(cpu_clip_space)),
                                             detail::in_double(shadow_scene::spot(opengl_clip_space))}) {
        const glm::ivec2 size(256, 128);
        const glm::dvec2 exact = make_light_units(light, size);
        const glm::dmat4 m = texture_matrix(light, size);
        for (const glm::dmat4& here : {m, detail::moved_to(m, detail::anchor_of(m, size))}) {
            const glm::dvec2 units = detail::map_units(here, size);
            CHECK(units.x == doctest::Approx(exact.x).epsilon(1e-6));
            CHECK(units.y == doctest::Approx(exact.y).epsilon(1e-6));
            CHECK(detail::width_in_depth(here, size) == doctest::Approx(exact.x * exact.y).epsilon(1e-6));
        }
    }
}

TEST_CASE(
    "map_slack: the rounding of a warped map whose box reaches beyond its horizon counts all that lies before it") {
    // a perspective warp, 2000 times its size from the origin: one corner's w is -7
    const glm::dmat4 m = glm::transpose(glm::dmat4(-0.00429404, 0.00121989, -0.0136082, 183.237,       //
                                                   -0.0500929, 0.0190806, -0.0252019, 466.166,         //
                                                   -9.32834e-05, 9.83861e-05, -3.78751e-05, 0.959001,  //
                                                   -0.000113062, 4.35397e-05, -4.38245e-05, 1.91808));
    const glm::ivec2 size(191, 486);
    const glm::dvec4 error = detail::rounding_of(m, size, {5.42468e+06, -3.35232e+08, -2.57935e+08});
    for (glm::length_t i = 0; i < 4; ++i) CHECK(error[i] > 0);
    const glm::dmat4 back = glm::inverse(m);
    int before = 0, beyond = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec4 h = back * glm::dvec4(i % 10 / 9.0 * size.x, i / 10 % 10 / 9.0 * size.y, i / 100 / 9.0, 1);
        ++(h.w > 0 ? before : beyond);
        if (h.w > 0) CHECK(error.x > 9.99 * 0x1p-24 * glm::length(detail::row_of(m, 3)) * glm::length(glm::dvec3(h)));
    }
    CHECK(before > 500);
    CHECK(beyond > 10);
}

TEST_CASE("map_slack: a texel's width along the light is in a place's slack, at any distance from the light") {
    const light_space<double> light = detail::in_double(shadow_scene::spot(cpu_clip_space));
    const glm::ivec2 size(256);
    const glm::dvec2 units = make_light_units(light, size);
    const single_map lamp(light);
    const auto u = lamp.make_uniforms(size, glm::dvec3(0));
    const glm::dmat4 m = texture_matrix(light, size);
    for (const double depth : {0.1, 0.5, 0.9}) {
        const glm::dvec4 h = glm::inverse(m) * glm::dvec4(128, 128, depth, 1);
        const glm::dvec3 at = glm::dvec3(h) / h.w;
        const double w = shadow_coordinate(m, at).w, width = units.x * units.y / w;
        const float slack = single_map::places(u, {}, glm::vec3(at), glm::vec3(0))[0].slack;
        CHECK(slack > width);
        CHECK(slack < 1.001 * width);
    }
}

namespace {

/// A hall, seen by a camera.
warp_fit<double> hall(glm::dvec3 direction, clip_space clip) {
    const frustum<double> camera{.position = {0, 3, 12},
                                 .direction = {0.1, -0.3, -1},
                                 .tan_half_x = 0.7,
                                 .tan_half_y = 0.5,
                                 .z_near = 0.2,
                                 .z_far = 40};
    return {.camera = camera,
            .direction = direction,
            .receivers = intersection(camera, bounding_box<double>{{-8, 0, -12}, {8, 5, 8}}),
            .clip = clip};
}

/// Most of the world that the bias of receivers on a floor hides, along rays.
double hidden(const single_map& map, glm::dvec4 source) {
    const glm::ivec2 size(512);
    const anchored_map u = map.make_uniforms(size, glm::dvec3(0));
    const glm::dmat4 m = texture_matrix(map.light, size);
    double most = 0;
    for (const glm::dvec3 p : {glm::dvec3(0, 0, 6), glm::dvec3(1, 0, 0), glm::dvec3(-2, 0, -8)}) {
        const map_place at = single_map_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, {}, glm::vec3(p),
                                               glm::vec3(0, 1, 0))[0];
        const double unit = light_units_at(m, glm::dvec3(source) - source.w * p, p).units.y;
        most = std::max(most, double(at.slack) / unit);
    }
    return most;
}

}  // namespace

TEST_CASE("map_slack: a tall box of casters costs warped maps of suns few digits, a small near plane those of lamps") {
    const glm::dvec4 ground(0, 1, 0, 0);
    for (const clip_space& clip : {cpu_clip_space, opengl_clip_space, godot_clip_space}) {
        const auto suns = [&](double height) {
            auto fit = hall({0.3, -1, 0.1}, clip);
            fit.casters = bounding_box<double>{{-8, 0, -12}, {8, height, 8}};
            return std::vector<light_space<double>>{fit_light_space_perspective(fit).light,
                                                    fit_trapezoidal(fit, 4.0).light, fit_perspective(fit).light,
                                                    fit_plane_optimal(fit, ground).value().light};
        };
        const glm::dvec4 along(-0.3, 1, -0.1, 0);
        for (const double height : {1e3, 1e5})
            for (std::size_t i = 0; i < 4; ++i) {
                CHECK_FALSE(detail::rays_meet(texture_matrix(suns(height)[i], {512, 512})));
                const double low = hidden(single_map(suns(5)[i]), along);
                CHECK(hidden(single_map(suns(height)[i]), along) < 1.1 * low + 2e-6 * height);
            }
        const auto lamps = [&](double z_near) {
            const light_position<double> lamp{.position = {1, 11, -1}, .z_near = z_near};
            const auto fit = hall({0, -1, 0}, clip);
            return std::vector<light_space<double>>{fit_perspective(fit, lamp).light,
                                                    fit_plane_optimal(fit, ground, lamp).value().light};
        };
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(detail::rays_meet(texture_matrix(lamps(0.01)[i], {512, 512})));
            const double large = hidden(single_map(lamps(0.5)[i]), {1, 11, -1, 1});
            CHECK(hidden(single_map(lamps(0.01)[i]), {1, 11, -1, 1}) < 1.2 * large);
        }
    }
}

TEST_CASE("map_slack: a warp over more depth than floats tell is refused by name") {
    auto fit = hall({0.3, -1, 0.1}, cpu_clip_space);
    const auto with_casters = [&](double side) {
        fit.casters = bounding_box<double>{glm::dvec3(-side), glm::dvec3(side)};
        return single_map(fit_light_space_perspective(fit, 1.0).light);
    };
    CHECK_NOTHROW((void)with_casters(1e4).make_uniforms({512, 512}, glm::dvec3(0)));
    CHECK_THROWS_WITH_AS((void)with_casters(1e6).make_uniforms({512, 512}, glm::dvec3(0)),
                         doctest::Contains("umbrage::shadow: light must be such that its bias hides less than"),
                         std::invalid_argument);
}
