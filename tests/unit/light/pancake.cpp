// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <random>
#include <vector>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/pancake.hpp>

#include "bodies.hpp"
#include "clip_spaces.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("pancake: by hand in every convention", T, float, double) {
    using vec = glm::vec<4, T>;
    CHECK(pancake(vec(1, 2, -3, 4), T(0)) == vec(1, 2, 0, 4));
    CHECK(pancake(vec(1, 2, 3, 4), T(0)) == vec(1, 2, 3, 4));
    CHECK(pancake(vec(1, 2, -5, 4), T(-1)) == vec(1, 2, -4, 4));
    CHECK(pancake(vec(1, 2, -3, 4), T(-1)) == vec(1, 2, -3, 4));
    CHECK(pancake(vec(1, 2, 5, 4), T(1)) == vec(1, 2, 4, 4));
    CHECK(pancake(vec(1, 2, -5, 4), T(1)) == vec(1, 2, -5, 4));
    CHECK(near_depth(opengl_clip_space) == -1.0f);
    CHECK(near_depth(vulkan_clip_space) == 0.0f);
    CHECK(near_depth({.range = depth_range::minus_one_to_one, .direction = depth_direction::reversed}) == 1.0f);
}

TEST_CASE("pancake: triangles before the near plane or behind it draw what a near plane that clamps draws") {
    std::mt19937 random(1);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const glm::vec3 direction(glm::normalize(bodies::random_vector(random, -1, 1)));
        const auto light = fit_directional_light<float>(
            {.direction = direction, .receivers = bounding_box<float>{}, .clip = clip});  // of a box around 0
        std::vector<glm::vec3> positions, pressed;
        std::vector<glm::uvec3> triangles;
        for (unsigned i = 0; i < 60; i += 3) {
            triangles.emplace_back(i, i + 1, i + 2);
            for (int k = 0; k < 3; ++k)
                positions.push_back(glm::vec3(bodies::random_vector(random, -0.7, 0.7)) -
                                    (i % 2 ? 5.0f : 0.0f) * direction);
        }
        const glm::mat4 matrix = light.projection * light.view;
        for (glm::vec3 p : positions) pressed.emplace_back(pancake(matrix * glm::vec4(p, 1), near_depth(clip)));
        image<float> by_rasterizer({64, 64}, cleared_depth(clip)), by_vertex = by_rasterizer;
        rasterize_depth(by_rasterizer, {positions, triangles}, matrix, clip, cull_mode::none, serial{},
                        near_plane::clamps);
        rasterize_depth(by_vertex, {pressed, triangles}, glm::mat4(1), clip);
        int near = 0, unlike = 0, elsewhere = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const float a = by_rasterizer[{x, y}], b = by_vertex[{x, y}];
                elsewhere += (a == cleared_depth(clip)) != (b == cleared_depth(clip));
                near += a == 1.0f - cleared_depth(clip);
                unlike += (a == cleared_depth(clip)) == (b == cleared_depth(clip)) && std::abs(a - b) > 1e-5f;
            }
        CHECK(near > 100);
        CHECK(elsewhere < 20);  // of 4096, where rounding moves an edge by 1/256 texel
        CHECK(unlike == 0);
    }
}
