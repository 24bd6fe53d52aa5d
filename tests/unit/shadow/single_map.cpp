// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/shadow/single_map.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("single_map: uniforms are the map of the light, anchored") {
    const single_map of(shadow_scene::spot(cpu_clip_space));
    const auto u = of.make_uniforms({64, 32}, glm::dvec3(0));
    CHECK(glm::vec3(u.anchor) == glm::vec3(0.5f, 8, 0.25f));
    CHECK(of.lights().size() == 1);
    CHECK(of.clip() == cpu_clip_space);
    const glm::dmat4 exact = texture_matrix(of.light, {64, 32});
    for (int i = 0; i < 500; ++i) {
        const glm::vec3 world(float(i % 13) - 6.1f, float(i % 7) - 3.3f, float(i % 11) - 5.2f);
        const map_place place = single_map::places(u, {}, world, {1, 3, 2})[0];
        const glm::dvec3 at = project_coordinate(shadow_coordinate(exact, glm::dvec3(world)));
        CHECK(glm::length(glm::dvec2(place.at) - glm::dvec2(at)) < 1e-4);
        CHECK(glm::abs(place.at.z - at.z) < place.slack - detail::spare_slack(exact, {64, 32}, place));
        const glm::dvec2 slope = plane_slope(plane_matrix(exact), glm::dvec3(1, 3, 2), glm::dvec3(world));
        CHECK(glm::length(glm::dvec2(place.slope) - slope) < 1e-5);
    }
}

TEST_CASE("single_map: parallel rays have the same places by their own snippet") {
    for (const clip_space clip : {cpu_clip_space, opengl_clip_space, unity_clip_space}) {
        const single_map sun(shadow_scene::fitted(clip)), lamp(shadow_scene::spot(clip));
        CHECK(sun.placing == &glsl::parallel_map_places);
        CHECK(lamp.placing == &glsl::single_map_places);
        const auto u = sun.make_uniforms({64, 32}, glm::dvec3(0));
        int differ = 0;
        for (int i = 0; i < 500; ++i) {
            const glm::vec3 world(float(i % 13) - 6.1f, float(i % 7) - 3.3f, float(i % 11) - 5.2f);
            const glm::vec3 normal = i % 17 == 0 ? glm::vec3(0) : glm::vec3(i % 5 - 2, i % 3, 0.3f);
            const map_place a = single_map::places(u, {}, world, normal)[0],
                            b = parallel_map_places(u.to_texels, u.planes, u.anchor, u.rounding, u.slack, {}, world,
                                                    normal)[0];
            differ += a.at != b.at || a.slope != b.slope || a.slack != b.slack || a.number != b.number;
        }
        CHECK(differ == 0);
    }
}

TEST_CASE("single_map: a light that says parallel, but whose projection has perspective, is refused") {
    light_space<float> light = shadow_scene::spot(cpu_clip_space);
    light.parallel = true;
    CHECK_THROWS_WITH_AS(
        single_map{light},
        doctest::Contains("umbrage::shadow: light.parallel must be false for a projection with perspective"),
        std::invalid_argument);
}

TEST_CASE("single_map: matrices without an inverse are refused in the shadow's name") {
    light_space<float> flat = shadow_scene::spot(cpu_clip_space);
    flat.projection[0] = glm::vec4(0);
    CHECK_THROWS_WITH_AS(
        shadow(flat, {64, 64}, filters::hard{}),
        doctest::Contains("umbrage::shadow: light and origin must be such that the map's matrix has a finite inverse"),
        std::invalid_argument);
}
