// SPDX-License-Identifier: MIT
//
// Depth against the exact plane; which depth wins.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "exact.hpp"
#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize: depth is the exact plane's, rounded once, but for the stated error") {
    generator random;
    const glm::ivec2 size(64, 48);
    long double worst_ulp = 0, worst_share = 0;
    int samples = 0;
    for (int round = 0; round < 4000; ++round) {
        exact_triangle oracle;
        mesh m;
        std::array<glm::vec3, 3> p;
        const exact_scene scene({random(-100, 100), random(-100, 100), random(1500, 2500), random(-100, 100)});
        const int reach = round % 4 == 0 ? 6 : 200;  // small triangles, and slivers among them, as well as large ones
        const glm::ivec2 center(random(-60, 60), random(-60, 60));
        for (std::size_t i = 0; i < 3; ++i) {
            const int w = random(50, 90), x = center.x + random(-reach, reach), y = center.y + random(-reach, reach);
            oracle.v[i] = scene.vertex(x, y, w);
            oracle.v[i].snap(size);
            p[i] = scene.position(x, y, w);
        }
        m.add(p[0], p[1], p[2]);

        // what the documentation calls n and m
        const auto& v = oracle.v;
        const auto [left, right] = std::minmax({v[0].column, v[1].column, v[2].column});
        const auto [bottom, top] = std::minmax({v[0].row, v[1].row, v[2].row});
        const auto real = [](std::int64_t i) { return static_cast<long double>(i); };
        const auto z = [&](std::size_t i) { return real(v[i].z) / real(v[i].w); };
        const auto slope = [&](auto coordinate) {
            return std::abs(((z(1) - z(0)) * real(coordinate(v[2]) - coordinate(v[0])) -
                             (z(2) - z(0)) * real(coordinate(v[1]) - coordinate(v[0]))) /
                            real(oracle.area()));
        };
        if (oracle.area() == 0) continue;
        const auto largest = std::max({std::abs(z(0)), std::abs(z(1)), std::abs(z(2))});
        const auto magnitude = largest + slope([](auto& c) { return c.row; }) * real(right - left) +
                               slope([](auto& c) { return c.column; }) * real(top - bottom);
        const auto stated = 0x1p-48L * real(std::max(right - left, top - bottom)) * magnitude;

        rasterize(size, m, scene.matrix, cpu_clip_space, [&](glm::ivec2 texel, float depth, unsigned) {
            const auto exact = oracle.depth(texel);
            const auto error = std::abs(static_cast<long double>(depth) - exact);
            const auto ulp = static_cast<long double>(std::nextafter(depth, 2.0f)) - static_cast<long double>(depth);
            worst_share = std::max(worst_share, (error - ulp / 2) / stated);
            if (magnitude < 4 * largest) worst_ulp = std::max(worst_ulp, error / ulp);
            ++samples;
        });
    }
    CHECK(samples > 500000);
    CHECK(worst_share <= 1.0L);
    CHECK(worst_ulp < 0.501L);
    MESSAGE("worst error " << double(worst_ulp) << " ulp, slivers left out; beyond rounding " << double(worst_share)
                           << " of what is stated, slivers and all; " << samples << " samples");
}

TEST_CASE("rasterize_depth: nearer or as near wins, nothing beyond the far plane, never a negative zero") {
    const auto screen = [](float z) {
        mesh m;
        m.add({-1, -1, z}, {3, -1, z}, {-1, 3, z});
        return m;
    };
    const clip_space forward = cpu_clip_space, reversed = godot_clip_space;
    const auto after = [&](float there, float z, clip_space clip) {
        image<float> depth({3, 3}, there);
        rasterize_depth(depth, screen(z), glm::mat4(1.0f), clip);
        CHECK(all(depth, depth[{1, 1}]));
        return depth[{1, 1}];
    };
    CHECK(after(0.5f, 0.25f, forward) == 0.25f);
    CHECK(after(0.5f, 0.75f, forward) == 0.5f);
    CHECK(after(0.5f, 0.25f, reversed) == 0.5f);
    CHECK(after(0.5f, 0.75f, reversed) == 0.75f);
    CHECK(after(2.0f, 1.0f, forward) == 1.0f);
    CHECK(after(2.0f, 1.5f, forward) == 2.0f);
    CHECK(after(-1.0f, -0.5f, reversed) == -1.0f);
    CHECK(after(2.0f, -0.5f, forward) == 2.0f);  // before the near plane
    CHECK(after(-1.0f, 1.5f, reversed) == -1.0f);
    CHECK(is_nan(after(nan_value, 0.5f, forward)));
    CHECK(std::bit_cast<unsigned>(after(1.0f, -0.0f, forward)) == 0u);
    CHECK(std::bit_cast<unsigned>(after(-0.0f, -0.0f, forward)) == 0u);  // a tie goes to the newcomer
    CHECK(std::bit_cast<unsigned>(after(-1.0f, -0.0f, reversed)) == 0u);

    mesh across;  // from depth -1 to 3 over the width: only the middle half is between the planes
    across.positions = {{-2, -1, -3}, {2, -1, 5}, {2, 1, 5}, {-2, 1, -3}};
    across.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (clip_space clip : {forward, reversed}) {
        const auto depth = render({64, 8}, across, glm::mat4(1.0f), clip);
        for (int x = 0; x < 64; ++x) {
            const double expected = (x + 0.5) / 16.0 - 1.0;
            const bool seen = expected > 0.0 && expected < 1.0;
            CHECK(std::abs(depth[{x, 3}] - (seen ? expected : cleared_depth(clip))) < 1e-6);
        }
    }
}

TEST_CASE("rasterize: a visibility buffer and its depths agree with rasterize_depth") {
    generator random;
    const glm::ivec2 size(96, 64);
    const mesh m = soup(random, 300);
    image<float> depth(size, 1.0f);
    image<unsigned> visible(size, ~0u);
    rasterize(size, m, perspective(), cpu_clip_space, [&](glm::ivec2 texel, float z, unsigned triangle) {
        if (z <= depth[texel]) depth[texel] = z, visible[texel] = triangle;
    });
    CHECK(same_bits(depth, render(size, m, perspective())));
}
