// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include <umbrage/depth/rg.hpp>
#include <umbrage/shadow/probe.hpp>

#include "scene.hpp"

using namespace umbrage;

namespace {

constexpr glm::vec3 up_there(0, 1, 0), out_of_map(1, 1, 1), behind_light(0, 0, 0), past_far(0, 1, 1);

}  // namespace

TEST_CASE("probe: lit and shadowed points of the scene are texels, in every setup") {
    shadow_scene::for_each_shadow(cpu_clip_space, filters::tent<3>, rg<11>{}, [](const auto& s) {
        std::set<std::tuple<float, float, float>> colors;
        for (float x = -1.0f; x < 1.0f; x += 0.05f) {
            const glm::vec3 c = probe(s, {x, 0, 0.3f}, up_there);
            colors.insert({c.x, c.y, c.z});
            for (int i = 0; i < 3; ++i) CHECK((c[i] > 0.28f && c[i] < 0.88f));
        }
        CHECK(colors.size() > 1);  // squares
    });
}

TEST_CASE("probe: what cannot be shadowed has a color of its own") {
    const shadow spot(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::pcf_2x2{});
    CHECK(probe(spot, {0, 20, 0}, up_there) == behind_light);
    CHECK(probe(spot, {300, 0, 0}, up_there) == out_of_map);
    CHECK(probe(spot, {0, -5000, 0}, up_there) == past_far);
    CHECK(probe(spot, {0, 0, 0}, {0, 0, 0}) == glm::vec3(1, 1, 0));
    CHECK(probe(spot, {0, std::numeric_limits<float>::quiet_NaN(), 0}, up_there) == glm::vec3(1, 0, 1));
    CHECK(probe(spot, {0, 0, 0}, {std::numeric_limits<float>::infinity(), 0, 0}) == glm::vec3(1, 0, 1));
    const glm::vec3 along_light(1, 0, 0);  // a wall seen edge-on: no finite slope
    CHECK(probe(spot, {0.5f, 0, 0.25f}, along_light) == glm::vec3(1, 0, 0));
}

TEST_CASE("probe: cascades have colors of their own, and fade into each other") {
    const shadow sun(shadow_scene::cascades(cpu_clip_space), {256, 256}, filters::pcf_2x2{});
    const shadow hard_changes(cascaded_maps(shadow_scene::cascades(cpu_clip_space), 0.0f), {256, 256},
                              filters::pcf_2x2{});
    std::set<float> of_last_bits;
    bool blends = false, ends = false;
    for (float z = 14; z > -200; z -= 0.03f) {
        const glm::vec3 c = probe(sun, {0.1f, 0, z}, up_there), hard = probe(hard_changes, {0.1f, 0, z}, up_there);
        blends = blends || (c != hard && hard != out_of_map);
        ends = ends || hard == out_of_map;
        of_last_bits.insert(hard.x / hard.y);
    }
    CHECK(blends);
    CHECK(ends);
    CHECK(of_last_bits.size() >= 3);
}

TEST_CASE("probe: reversed depth says the same") {
    clip_space reversed = cpu_clip_space;
    reversed.direction = depth_direction::reversed;
    const shadow spot(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::pcf_2x2{});
    const shadow other(shadow_scene::spot(reversed), {256, 256}, filters::pcf_2x2{});
    for (const glm::vec3 p : {glm::vec3(0, 0, 0), {0, -5000, 0}, {0, 20, 0}, {300, 0, 0}, {1, 2, 1}})
        CHECK(probe(spot, p, up_there) == probe(other, p, up_there));
}
