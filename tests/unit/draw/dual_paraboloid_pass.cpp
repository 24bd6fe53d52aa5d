// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/draw/dual_paraboloid_pass.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <umbrage/draw/tessellate.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

TEST_CASE("rasterize_dual_paraboloid: a room's walls at their distances, in every convention, behind the rim too") {
    const glm::vec3 position(0.5f, -0.3f, 0.2f), low(-3, -2, -4), high(2, 3, 4);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    const std::vector<glm::uvec3> walls{{0, 1, 2}, {1, 2, 3}, {4, 5, 6}, {5, 6, 7}, {0, 1, 4}, {1, 4, 5},
                                        {2, 3, 6}, {3, 6, 7}, {0, 2, 4}, {2, 4, 6}, {1, 3, 5}, {3, 5, 7}};
    constexpr int size = 96, border = 4;
    const tessellation to{position, paraboloid_edge_angle(size, border), 10, 0x1p-12f};
    const tessellated_mesh cut = tessellate({corners, walls}, to);
    for (const clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto light = make_dual_paraboloid_light<float>(
            {.position = position, .range = to.range, .map_size = size, .border = border, .clip = clip});
        int wrong = 0, seen = 0, behind_the_rim = 0;
        for (const int map : {0, 1}) {
            image<float> depth(glm::ivec2(size), cleared_depth(clip));
            rasterize_dual_paraboloid(depth.view(), cut.view(), light, map);
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const glm::dvec2 p = (glm::dvec2(x, y) + 0.5 - size / 2.0) / (size / 2.0 - border);
                    const double r = glm::dot(p, p);
                    if (std::sqrt(r) > 1 + (std::sqrt(2.0) * border - 1) / (size / 2.0 - border)) continue;
                    const double turn = map == 0 ? -1 : 1;
                    const glm::dvec3 d = glm::dvec3(turn * 2 * p.x, 2 * p.y, -turn * (1 - r)) / (1 + r);
                    double distance = 1e9, gradient = 0;
                    for (glm::length_t k = 0; k < 3; ++k) {
                        const double to_wall = ((d[k] > 0 ? high : low)[k] - position[k]) / d[k];
                        if (to_wall < distance)
                            distance = to_wall, gradient = std::sqrt(1 - d[k] * d[k]) / std::abs(d[k]);
                    }
                    const double is = clip.direction == depth_direction::forward ? depth[{x, y}] : 1 - depth[{x, y}];
                    const double texel = (1 + r > 2 ? 2 : 2 / (1 + r)) * 2 / (size - 2 * border);  // radians
                    const double may_be = to.depth_error + distance / to.range * gradient * texel * 0.75;
                    wrong += !(std::abs(is - distance / to.range) <= may_be);
                    ++seen;
                    behind_the_rim += r > 1;
                }
        }
        CHECK(seen > 2 * 6000);
        CHECK(behind_the_rim > 500);
        CHECK(wrong == 0);
    }
}

TEST_CASE("rasterize_dual_paraboloid: refuses a third map") {
    const auto light = make_dual_paraboloid_light<float>({.map_size = 16, .clip = cpu_clip_space});
    image<float> depth(glm::ivec2(16), 1.0f);
    for (const int map : {-1, 2, 5})
        CHECK_THROWS_AS(rasterize_dual_paraboloid(depth.view(), {}, light, map), std::invalid_argument);
}
