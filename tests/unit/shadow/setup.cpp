// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/setup.hpp>

#include "own_setup.hpp"
#include "scene.hpp"

using namespace umbrage;

namespace {

/// A setup of two lights that says it has one map.
struct narrow : own::up_and_down {
    static constexpr map_grid grid{1, 1};
};

}  // namespace

TEST_CASE("setup: a shadow takes one of a user's own") {
    static_assert(shadow_setup<own::up_and_down>);
    const shadow lamp(own::up_and_down{{0.5, 1, 0.25}, cpu_clip_space}, {256, 256}, filters::hard{});
    const auto map = shadow_scene::drawn(lamp);  // the lamp hangs between the floor and the table
    CHECK(lamp(map, {3, 0, 0}, {0, 1, 0}) == 1.0f);
    CHECK(lamp(map, {0, 2, 0}, {0, -1, 0}) == 1.0f);
    CHECK(lamp(map, {0.5f, 4, 0.25f}, {0, -1, 0}) == 0.0f);
    CHECK(lamp(map, {6, 4, 0.25f}, {0, -1, 0}) == 1.0f);
    const image<glm::vec3> points({2, 1}, glm::vec3(0.5f, 4, 0.25f)), normals({2, 1}, glm::vec3(0, -1, 0));
    image<float> seen({2, 1});
    lamp.visibility(map, points, normals, seen);
    CHECK(seen[{1, 0}] == 0.0f);
}

TEST_CASE("setup: a light without a map in the grid is refused") {
    const narrow two{{{0.5, 1, 0.25}, cpu_clip_space}};
    CHECK_THROWS_WITH_AS((shadow<narrow, filters::hard>(two, {64, 64})),
                         "umbrage::shadow: light.lights() must be as many as the setup's grid has maps, at most; got 2",
                         std::invalid_argument);
}

TEST_CASE("setup: blocks are mat4s and vec4s without gaps, as all languages lay them out") {
    shadow_scene::for_each_shadow(cpu_clip_space, filters::hard{}, depth32f{}, [](const auto& s) {
        using setup = std::remove_cvref_t<decltype(s.setup())>;
        std::size_t vectors = 0;
        for (const uniform_field& f : setup::fields) vectors += f.vectors();
        for (const uniform_field& f : shadow_terms::fields) vectors += f.vectors();
        CHECK(sizeof(s.uniforms()) == vectors * sizeof(glm::vec4));
    });
}
