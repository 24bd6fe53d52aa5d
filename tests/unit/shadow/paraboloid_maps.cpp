// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>

#include "borders.hpp"
#include "scene.hpp"

using namespace umbrage;

TEST_CASE("paraboloid_maps: a point lies where the depth pass draws it") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const paraboloid_maps of(shadow_scene::paraboloids(clip));
        const auto u = of.make_uniforms({512, 512}, glm::dvec3(0));
        const light_space<double> light = of.lights()[0];
        int met[2]{};
        for (int i = 0; i < 600; ++i) {
            const glm::vec3 world(float(i % 13) - 6.1f, float(i % 7) * 4 - 3.3f, float(i % 11) - 5.2f);
            static_cast<void>(
                detail::blended(paraboloid_maps::places(u, {}, world, {0, 1, 0}), [&](const map_place& place) {
                    const glm::dvec3 way = glm::dvec3(world) - of.light.position;
                    const glm::dvec4 h = light.projection * dual_paraboloid_position(way, double(place.number));
                    const light_space<double> ndc{.clip = clip};
                    const glm::dvec3 drawn = glm::dvec3(texture_matrix(ndc, {512, 512}) * (h / h.w));
                    CHECK(glm::length(glm::dvec2(place.at) - glm::dvec2(drawn)) < 1e-3);
                    CHECK(glm::abs(place.at.z - drawn.z) < 1e-6);
                    ++met[place.number];
                    return 1.0f;
                }));
        }
        for (const int n : met) CHECK(n > 10);
    }
}

TEST_CASE("paraboloid_maps: maps have the light's size") {
    const paraboloid_maps of(shadow_scene::paraboloids(cpu_clip_space));
    CHECK_THROWS_WITH_AS(static_cast<void>(of.make_uniforms({512, 128}, glm::dvec3(0))),
                         "umbrage::shadow: map_size must be the paraboloid light's, 512 x 512; got 512 x 128",
                         std::invalid_argument);
}

TEST_CASE("paraboloid_maps: where no digits are left, the light is refused by name") {
    const auto at = [](float away) {
        return shadow(dual_paraboloid_light<float>{.position = {away, 3, 0}, .range = 20, .clip = cpu_clip_space},
                      glm::ivec2(dual_paraboloid_light<float>{}.map_size), filters::hard{});
    };
    CHECK_NOTHROW(static_cast<void>(at(4e4f)));
    CHECK_THROWS_AS(static_cast<void>(at(5e4f)), std::invalid_argument);
    CHECK_NOTHROW(static_cast<void>(shadow(
        dual_paraboloid_light<double>{.position = {5e7, 3, 0}, .range = 20, .clip = cpu_clip_space},
        glm::ivec2(dual_paraboloid_light<double>{}.map_size), filters::hard{}, depth32f{}, glm::dvec3(5e7, 0, 0))));
}

TEST_CASE("paraboloid_maps: a border as wide as the filter reaches, and no narrower one") {
    const dual_paraboloid_light<float> bulb{.map_size = 64, .clip = cpu_clip_space};
    shadow_borders::check_need(bulb, shadow_borders::in_square(64));
    shadow_borders::check_refusal(bulb);
}
