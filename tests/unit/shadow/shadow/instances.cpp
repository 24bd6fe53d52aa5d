// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <umbrage/filter/pcf/hard.hpp>

#include "../../images/last_piece_first.hpp"
#include "../scene.hpp"

using namespace umbrage;
using namespace shadow_scene;

TEST_CASE("shadow: instances are drawn as their meshes in the world are, for every setup") {
    const std::vector<glm::vec3> corners{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    const std::vector<glm::uvec3> two{{0, 1, 2}, {0, 2, 3}};
    std::vector<glm::mat4> places(3, glm::mat4(1));  // where nothing rounds
    places[0][3] = {0, 2, 0, 1};
    places[1][3] = {4, 1, -3, 1}, places[1][0] *= -2.0f;
    places[2][3] = {-2, 1, 5, 1}, places[2][1][1] = std::numeric_limits<float>::quiet_NaN();
    for_each_light(cpu_clip_space, [&](const auto& light, glm::ivec2 map_size) {
        const umbrage::shadow s(light, map_size, filters::hard{});
        image<float> expected(s.size(), s.cleared()), got = expected, in_pieces = expected;
        const image<float> empty = expected;
        for (const glm::mat4& place : {places[0], places[1]}) {
            std::vector<glm::vec3> world;
            for (const glm::vec3& p : corners) world.emplace_back(place * glm::vec4(p, 1));
            s.draw(expected, {world, two});
        }
        s.draw(got, {corners, two}, places);
        s.draw(in_pieces, {corners, two}, places, last_piece_first{5});
        const auto bytes = [](const image<float>& of) { return std::as_bytes(std::span(of.texels())); };
        CHECK_FALSE(std::ranges::equal(bytes(got), bytes(empty)));
        CHECK(std::ranges::equal(bytes(got), bytes(in_pieces)));
        double worst = 0;  // matrices of instances are rounded
        for (std::size_t i = 0; i < got.texels().size(); ++i)
            worst = std::max(worst, double(std::abs(got.texels()[i] - expected.texels()[i])));
        CHECK(worst < 1e-5);
    });
}
