// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/shadow/tetrahedron_map.hpp>

#include "borders.hpp"
#include "scene.hpp"

using namespace umbrage;

TEST_CASE("tetrahedron_map: a point lies where its face's own matrices draw it") {
    for (const clip_space clip : {opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space}) {
        const tetrahedron_map of(shadow_scene::tetrahedron(clip));
        const auto u = of.make_uniforms({512, 512}, glm::dvec3(0));
        const auto faces = of.lights();
        int met[4]{};
        for (int i = 0; i < 600; ++i) {
            const glm::vec3 world(float(i % 13) - 6.1f, float(i % 7) * 4 - 3.3f, float(i % 11) - 5.2f);
            const int face = tetrahedron_face(world - glm::vec3(u.anchor));
            const map_place place = tetrahedron_map::places(u, {}, world, {0, 1, 0})[0];
            const auto m = texture_matrix(faces[std::size_t(face)], {512, 512});
            const glm::dvec3 drawn = project_coordinate(shadow_coordinate(m, glm::dvec3(world)));
            CHECK(glm::length(glm::dvec2(place.at) - glm::dvec2(drawn)) < 1e-3);
            CHECK(glm::abs(place.at.z - drawn.z) < 1e-6);
            const glm::dvec2 slope = plane_slope(plane_matrix(m), glm::dvec3(0, 1, 0), glm::dvec3(world));
            CHECK(glm::length(glm::dvec2(place.slope) - slope) < 1e-4 * (1 + glm::length(slope)));
            ++met[face];
        }
        for (const int n : met) CHECK(n > 10);
    }
}

TEST_CASE("tetrahedron_map: the map has the light's size") {
    const tetrahedron_map of(shadow_scene::tetrahedron(cpu_clip_space));
    CHECK_THROWS_WITH_AS(static_cast<void>(of.make_uniforms({512, 128}, glm::dvec3(0))),
                         "umbrage::shadow: map_size must be the tetrahedron light's, 512 x 512; got 512 x 128",
                         std::invalid_argument);
}

TEST_CASE("tetrahedron_map: a border as wide as the filter reaches, and no narrower one") {
    const auto in_triangle = [](glm::vec3 way, glm::ivec2 texel) {
        return shadow_borders::in_square(128)(way, texel) &&
               tetrahedron_face_of(glm::vec2(texel), 128.0f) == tetrahedron_face(way);
    };
    const tetrahedron_light<float> bulb{.map_size = 128, .clip = cpu_clip_space};
    shadow_borders::check_need(bulb, in_triangle);
    shadow_borders::check_refusal(bulb);
}
