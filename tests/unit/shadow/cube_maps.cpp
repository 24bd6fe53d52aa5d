// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/frame.hpp>

#include "borders.hpp"
#include "scene.hpp"

using namespace umbrage;

TEST_CASE("cube_maps: a point lies where its face's own matrices draw it") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const cube_maps of(shadow_scene::bulb(clip));
        const auto u = of.make_uniforms({256, 256}, glm::dvec3(0));
        const auto faces = of.lights();
        for (int i = 0; i < 600; ++i) {
            const glm::vec3 world(float(i % 13) - 6.1f, float(i % 7) * 2 - 3.3f, float(i % 11) - 5.2f);
            static_cast<void>(detail::blended(cube_maps::places(u, {}, world, {0, 1, 0}), [&](const map_place& place) {
                const auto m = texture_matrix(faces[std::size_t(place.number)], {256, 256});
                const glm::dvec3 drawn = project_coordinate(shadow_coordinate(m, glm::dvec3(world)));
                CHECK(glm::length(glm::dvec2(place.at) - glm::dvec2(drawn)) < 1e-3);
                CHECK(glm::abs(place.at.z - drawn.z) < 1e-6);
                const glm::dvec2 slope = plane_slope(plane_matrix(m), glm::dvec3(0, 1, 0), glm::dvec3(world));
                CHECK(glm::length(glm::dvec2(place.slope) - slope) < 1e-4 * (1 + glm::length(slope)));
                return 1.0f;
            }));
        }
    }
}

TEST_CASE("cube_maps: what stands where the lamp is, is lit, with and without a normal") {
    for (const clip_space clip : {opengl_clip_space, unity_clip_space}) {
        const point_light<float> bulb = shadow_scene::bulb(clip);
        const shadow lamp(bulb, glm::ivec2(bulb.map_size), filters::tent<3>);
        image<float> dark(lamp.size());  // every texel at the near plane
        for (float& depth : dark.texels()) depth = 1.0f - cleared_depth(clip);
        for (const glm::vec3 normal : {glm::vec3(0), glm::vec3(0, 1, 0)}) {
            CHECK(lamp(dark, bulb.position, normal) == 1.0f);
            CHECK(lamp(dark, bulb.position + glm::vec3(0, -3, 0.5f), normal) == 0.0f);
        }
    }
}

TEST_CASE("cube_maps: maps have the light's size") {
    const cube_maps of(shadow_scene::bulb(cpu_clip_space));
    CHECK_THROWS_WITH_AS(static_cast<void>(of.make_uniforms({256, 128}, glm::dvec3(0))),
                         "umbrage::shadow: map_size must be the point light's, 256 x 256; got 256 x 128",
                         std::invalid_argument);
}

TEST_CASE("cube_maps: a border as wide as the filter reaches, and no narrower one") {
    const point_light<float> bulb{.map_size = 64, .clip = cpu_clip_space};
    shadow_borders::check_need(bulb, shadow_borders::in_square(64));
    shadow_borders::check_refusal(bulb);
}
