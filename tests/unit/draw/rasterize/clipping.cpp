// SPDX-License-Identifier: MIT
//
// Triangles that reach beyond the near plane and the guard band.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize_depth: cut at the near plane, with corners behind the camera") {
    // near 2, far 64, a floor one unit below the camera from far in front to far behind: 2 <= -z, so y/w >= -1/2
    glm::mat4 matrix(0.0f);
    matrix[0][0] = matrix[1][1] = 1.0f;
    matrix[2][2] = -64.0f / 62.0f, matrix[3][2] = -128.0f / 62.0f, matrix[2][3] = -1.0f;
    mesh floor_below;
    floor_below.positions = {{-4000, -1, 50}, {4000, -1, 50}, {4000, -1, -4000}, {-4000, -1, -4000}};
    floor_below.triangles = {{0, 1, 2}, {0, 2, 3}};
    const glm::ivec2 size(64, 64);
    const auto depth = render(size, floor_below, matrix);
    const auto count = count_samples(size, floor_below, matrix);
    for (int y = 0; y < size.y; ++y) {
        const double up = (y + 0.5) / 32.0 - 1.0, distance = -1.0 / up;
        const bool seen = up < 0.0 && distance >= 2.0 && distance <= 64.0;
        for (int x = 0; x < size.x; ++x) {
            CHECK(count[{x, y}] == (seen ? 1 : 0));
            const double expected = seen ? (64.0 - 128.0 / distance) / 62.0 : 1.0;
            CHECK(std::abs(depth[{x, y}] - expected) < 128.0 / 62.0 / 32.0 / 512.0 + 1e-6);  // snapping: 1/512 texel
        }
    }

    const auto samples = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        mesh m;
        m.add(a, b, c);
        const auto image = count_samples(size, m, matrix);
        return std::accumulate(image.texels().begin(), image.texels().end(), 0);
    };
    CHECK(samples({-9, -9, -2}, {9, -9, -2}, {0, 18, -2}) == 64 * 64);  // in the near plane: inside
    CHECK(samples({-9, -9, -1.99f}, {9, -9, -1.99f}, {0, 18, -1.99f}) == 0);
    CHECK(samples({-9, -9, 5}, {9, -9, 5}, {0, 18, 5}) == 0);  // behind
    CHECK(samples({-9, -9, 0}, {9, -9, 0}, {0, 18, 0}) == 0);  // through the eye: w = 0
    CHECK(samples({0, 0, 0}, {0, 0, 0}, {0, 0, 0}) == 0);
    CHECK(samples({0, 0, -2}, {-9, -9, 5}, {9, -9, 5}) == 0);     // touches the near plane with a corner
    CHECK(samples({-1, 0, -2}, {1, 0, -2}, {0, 9, 5}) == 0);      // with an edge
    CHECK(samples({-2, -2, -2}, {2, -2, -2}, {0, 0, -4}) > 100);  // in front of it, on it with an edge

    glm::mat4 no_near(0.0f);  // z = 1/4, w = z: only w bounds it, and a corner has none
    no_near[0][0] = no_near[1][1] = no_near[2][3] = 1.0f, no_near[3][2] = 0.25f;
    mesh at_eye;
    at_eye.add({0, 0, 0}, {-1, -1, 1}, {1, -1, 1});  // edge-on
    CHECK(all(render(size, at_eye, no_near), 1.0f));

    mesh on_plane;
    on_plane.add({-9, -9, -2}, {9, -9, -2}, {0, 18, -2});
    CHECK(all(render(size, on_plane, matrix), 0.0f));
}

TEST_CASE("rasterize: huge triangles are cut at the guard band, along shared edges at the same points") {
    const glm::ivec2 size(64, 48);
    generator random;
    for (float far_out : {300.0f, 1e4f, 1e6f, 1e18f, 1e37f}) {
        for (int round = 0; round < 50; ++round) {
            mesh m;  // a fan around a corner in sight
            m.positions = {{random.real(-1, 1), random.real(-1, 1), 0.25f}};
            for (auto [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
                m.positions.emplace_back(float(x) * far_out, float(y) * far_out, 0.25f);
            m.triangles = {{0, 1, 2}, {2, 0, 3}, {4, 3, 0}, {0, 4, 1}};
            const auto count = count_samples(size, m);
            CHECK(std::all_of(count.texels().begin(), count.texels().end(), [](int n) { return n == 1; }));
            CHECK(all(render(size, m), 0.25f));
        }
        mesh slope;  // depth 0.25 on the left, 0.75 on the right
        slope.positions = {{-2, -far_out, 0}, {2, -far_out, 1}, {2, far_out, 1}, {-2, far_out, 0}};
        slope.triangles = {{0, 1, 2}, {0, 2, 3}};
        const auto depth = render(size, slope);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) CHECK(std::abs(depth[{x, y}] - (0.25 + (x + 0.5) / 128.0)) < 1e-4);
    }
    mesh whole_band;  // the largest image, one texel high: the right border is the band's
    whole_band.positions = {{-3, -3, 0.5f}, {9, -3, 0.5f}, {-3, 9, 0.5f}};
    whole_band.triangles = {{0, 1, 2}};
    CHECK(all(render({detail::guard_band, 1}, whole_band), 0.5f));
}
