// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <umbrage/shadow/cascade_choice.hpp>

#include "scene.hpp"

using namespace umbrage;
using glm::vec3;
using glm::vec4;

TEST_CASE(
    "cascade_choice: the edge of a cascade is 0 where its filter touches the border, and far outside its depths") {
    const vec4 scale(2, 4, 1, 0), offset(32, 16, 0, 0);
    const auto edge = [&](float x, float y, float z) { return cascade_edge({x, y, z}, scale, offset, {64, 32}, 2.0f); };
    CHECK(edge(0, 0, 0.5f) == -14.0f);
    CHECK(edge(15, 0, 0.5f) == 0.0f);  // 62 of 64 texels
    CHECK(edge(-16, 0, 0.5f) == 2.0f);
    CHECK(edge(0, 3.5f, 1.0f) == 0.0f);
    CHECK(edge(0, 0, 1.001f) == 65536.0f);
    CHECK(edge(0, 0, -0.001f) == 65536.0f);
    CHECK(edge(0, 0, std::numeric_limits<float>::quiet_NaN()) == 65536.0f);
}

TEST_CASE("cascade_choice: the first cascade that holds a point, and the edge of the next") {
    CHECK(first_cascade({0.0f, -3.0f, -9.0f, -20.0f}) == vec3(0, 0, -3));
    CHECK(first_cascade({1.0f, -3.0f, 9.0f, -20.0f}) == vec3(1, -3, 9));
    CHECK(first_cascade({1.0f, 3.0f, 9.0f, -20.0f}) == vec3(3, -20, 65536));
    CHECK(first_cascade(vec4(1.0f)) == vec3(4, 65536, 65536));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(first_cascade({nan, nan, -1.0f, nan}).x == 2);
}

TEST_CASE("cascade_choice: the next cascade takes what the first leaves, as far as it holds the point; then light") {
    const vec4 blending(1.0f / 16.0f, 2, 0, 0);
    CHECK(next_cascade_weight({0, -16, -40}, blending) == 0.0f);
    CHECK(next_cascade_weight({0, -8, -40}, blending) == 0.5f);
    CHECK(next_cascade_weight({0, 0, -40}, blending) == 1.0f);
    CHECK(next_cascade_weight({0, 0, -4}, blending) == 0.25f);
    CHECK(next_cascade_weight({0, 0, 1}, blending) == 0.0f);
    CHECK(next_cascade_weight({2, -8, 65536}, blending) == 0.5f);
    CHECK(next_cascade_weight({4, 65536, 65536}, blending) == 0.0f);
    CHECK(next_cascade_weight({0, 0, -40}, {0, 2, 0, 0}) == 0.0f);
}

TEST_CASE("cascade_choice: the fourth of eight cascades blends into the fifth") {
    const glm::mat4 rotation(1.0f);
    const vec4 at(32, 32, 0.5f, 0);
    const glm::mat4 offsets(at, at, at, at);
    glm::mat4 scales(0.0f), farther(0.0f);
    for (glm::length_t i = 0; i < 4; ++i) {
        scales[i] = vec4(std::ldexp(1.0f, -int(i)), std::ldexp(1.0f, -int(i)), 0, 0);
        farther[i] = scales[i] / 16.0f;
    }
    const shadow_terms terms{.map_size = glm::vec2(64), .reach = 2.0f};
    const auto choice = [&](float x) {
        return cascaded_maps_choice_8(rotation, scales, offsets, farther, offsets, vec4(0), {0.25f, 7, 0, 0}, terms,
                                      {x, 0, 0});
    };
    CHECK(choice(0) == glm::vec2(0, 0));
    CHECK(choice(200) == glm::vec2(3, 0));        // 25 texels from the middle: 5 from where the filter leaves the map
    CHECK(choice(8 * 28) == glm::vec2(3, 0.5f));  // 28 of 30 texels, in a band of 4
    CHECK(choice(8 * 31) == glm::vec2(4, 0));
    CHECK(choice(128 * 29) == glm::vec2(7, 0.75f));
    CHECK(choice(128 * 31) == glm::vec2(8, 0));
}
