// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/single_map.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("single_map: uniforms are the texture matrix and what sends planes there") {
    const single_map of(shadow_scene::spot(cpu_clip_space));
    const auto u = of.make_uniforms({64, 32}, glm::dvec3(0));
    CHECK(u.to_texels == glm::mat4(texture_matrix(of.light, {64, 32})));
    CHECK(u.planes == glm::mat4(plane_matrix(texture_matrix(of.light, {64, 32}))));
    CHECK(of.lights().size() == 1);
    CHECK(of.clip() == cpu_clip_space);
}
