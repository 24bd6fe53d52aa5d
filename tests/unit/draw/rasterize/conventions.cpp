// SPDX-License-Identifier: MIT
//
// Clip spaces and windings.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize_depth: all sixteen clip spaces show the same scene") {
    generator random;
    const glm::ivec2 size(80, 56);
    const mesh m = soup(random, 60);
    const auto reference = render(size, m, perspective());
    int covered = 0;
    for (float z : reference.texels()) covered += z < 1.0f;
    CHECK(covered > 1000);
    CHECK(covered < size.x * size.y);
    for (auto hand : {handedness::right, handedness::left})
        for (auto range : {depth_range::zero_to_one, depth_range::minus_one_to_one})
            for (auto direction : {depth_direction::forward, depth_direction::reversed})
                for (auto origin : {texture_origin::bottom, texture_origin::top}) {
                    const clip_space clip{hand, range, direction, origin};
                    mesh world = m;
                    glm::mat4 matrix = perspective();
                    for (int i = 0; i < 4; ++i) {
                        if (direction == depth_direction::reversed) matrix[i][2] = matrix[i][3] - matrix[i][2];
                        if (range == depth_range::minus_one_to_one) matrix[i][2] = 2.0f * matrix[i][2] - matrix[i][3];
                    }
                    if (hand == handedness::left) {
                        for (auto& p : world.positions) p.z = -p.z;
                        matrix[2] = -matrix[2];
                    }
                    const auto depth = render(size, world, matrix, clip);
                    int coverage_differs = 0;
                    float largest = 0.0f;
                    for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x) {
                            float z = depth[{x, origin == texture_origin::top ? size.y - 1 - y : y}];
                            if (direction == depth_direction::reversed) z = 1.0f - z;
                            const float expected = reference[{x, y}];
                            coverage_differs += (z != 1.0f) != (expected != 1.0f);
                            largest = std::max(largest, std::abs(z - expected));
                        }
                    CHECK(coverage_differs == 0);
                    CHECK(largest <= 0x1p-22f);  // the matrices are rounded
                    const bool same_depths = range == depth_range::zero_to_one && direction == depth_direction::forward;
                    CHECK((largest == 0.0f || !same_depths));
                }
}

TEST_CASE("rasterize_depth: faces left out") {
    mesh m;
    m.add({-1, -1, 0.5f}, {0, -1, 0.5f}, {-1, 1, 0.5f});  // counter-clockwise on the left, clockwise on the right
    m.add({0, 1, 0.5f}, {1, 1, 0.5f}, {1, -1, 0.5f});
    m.add({-50, -1, 0.5f}, {0, -1, -0.5f}, {-1, 900, 0.5f});  // the same way round when it is cut
    for (auto origin : {texture_origin::bottom, texture_origin::top})
        for (auto cull : {cull_mode::none, cull_mode::front, cull_mode::back}) {
            const clip_space clip{.range = depth_range::zero_to_one, .origin = origin};
            const auto depth = render({16, 16}, m, glm::mat4(1.0f), clip, cull);
            CHECK((depth[{1, 8}] == 0.5f) == (cull != cull_mode::front));
            CHECK((depth[{14, 8}] == 0.5f) == (cull != cull_mode::back));
            int called = 0;
            rasterize(
                {16, 16}, m, glm::mat4(1.0f), clip,
                [&](glm::ivec2 texel, float, unsigned triangle) {
                    ++called;
                    CHECK((triangle == 1) == (texel.x >= 8));
                    CHECK(cull != (triangle == 1 ? cull_mode::back : cull_mode::front));
                },
                cull);
            CHECK(called > 0);
        }
}
