// SPDX-License-Identifier: MIT
//
// Weights of a visibility buffer's triangles.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("barycentrics: the weighted corners project to the texel's center") {
    generator random;
    const glm::ivec2 size(96, 64);
    const mesh m = soup(random, 300);
    for (auto origin : {texture_origin::bottom, texture_origin::top}) {
        const clip_space clip{.range = depth_range::zero_to_one, .origin = origin};
        int seen = 0;
        double off = 0.0;
        rasterize(size, m, perspective(), clip, [&](glm::ivec2 texel, float, unsigned triangle) {
            const auto b = barycentrics(size, m, perspective(), clip, texel, triangle);
            CHECK(std::min({b.x, b.y, b.z}) >= 0.0f);
            CHECK(std::abs(b.x + b.y + b.z - 1.0f) < 1e-6f);
            const auto t = m.triangles[triangle];
            const auto p = glm::dvec3(m.positions[t.x]) * double(b.x) + glm::dvec3(m.positions[t.y]) * double(b.y) +
                           glm::dvec3(m.positions[t.z]) * double(b.z);
            const double x = (p.x / -p.z + 1.0) * 48.0, y = (p.y / -p.z + 1.0) * 32.0;
            off = std::max({off, std::abs(x - texel.x - 0.5),
                            std::abs((origin == texture_origin::top ? 64.0 - y : y) - texel.y - 0.5)});
            ++seen;
        });
        CHECK(seen > 3000);
        CHECK(off < 0.01);  // snapping moves edges by 1/512 texel a coordinate
    }
    mesh hand;  // w of 1, 1 and 3 along x: the middle of the screen is three quarters of the way to the near end
    hand.positions = {{-1, -1, -1}, {-1, 1, -1}, {3, 0, -3}};
    hand.triangles = {{0, 1, 2}};
    const auto b = barycentrics({2, 2}, hand, perspective(), cpu_clip_space, {0, 0}, 0);  // ndc (-1/2, -1/2)
    CHECK(std::abs(b.z - 0.1f) < 1e-6f);  // x / w = (-(1 - c) + 3 c) / (1 + 2 c) = -1/2
    CHECK(std::abs(b.x - b.y - 0.6f) < 1e-6f);

    mesh edge_on;
    edge_on.add({0, 0, -1}, {0, 1, -2}, {0, 2, -3});
    CHECK(barycentrics(size, edge_on, perspective(), cpu_clip_space, {48, 32}, 0).x <= 1.0f);
    edge_on.positions[1].x = nan_value;
    CHECK(barycentrics(size, edge_on, perspective(), cpu_clip_space, {48, 32}, 0) == glm::vec3(1, 0, 0));
    const mesh nothing{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
    CHECK(barycentrics(size, nothing, perspective(), cpu_clip_space, {48, 32}, 0) == glm::vec3(1, 0, 0));
}
