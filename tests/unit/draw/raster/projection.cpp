// SPDX-License-Identifier: MIT
#include <umbrage/draw/raster/projection.hpp>

#include <doctest/doctest.h>

#include <random>
#include <stdexcept>

#include "../../images/isas.hpp"

using namespace umbrage;
using namespace umbrage::detail;

TEST_CASE("projection: homogeneous texels and depth, for each depth range") {
    const projection p(glm::mat4(1.0f), opengl_clip_space, {64, 32});
    CHECK(p.homogeneous({-1, -1, -1}) == glm::dvec4(0, 0, 0, 1));
    CHECK(p.homogeneous({1, 0.5f, 0.5f}) == glm::dvec4(64, 24, 0.75, 1));
    CHECK(projection(glm::mat4(1.0f), cpu_clip_space, {64, 32}).homogeneous({1, 0.5f, 0.5f}) ==
          glm::dvec4(64, 24, 0.5, 1));
    CHECK_THROWS_AS(projection(glm::mat4(1.0f), cpu_clip_space, {-1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(projection(glm::mat4(1.0f), cpu_clip_space, {1, guard_band + 1}), std::invalid_argument);
}

TEST_CASE("projection: snaps to 1/256 texel, halves upwards, on either side of 0") {
    const projection p(glm::mat4(1.0f), cpu_clip_space, {1, 1});
    const auto column = [&](double steps) { return p.snap({steps * 3.0 / 256.0, 0.0, 0.0, 3.0}).x; };
    for (int i = -1000; i <= 1000; ++i) {
        CHECK(column(i) == i);
        CHECK(column(i - 0.5) == i);
        CHECK(column(i - 0.625) == i - 1);
        CHECK(column(i + 0.375) == i);
    }
}

TEST_CASE("projection: what each plane keeps out") {
    const projection p(glm::mat4(1.0f), cpu_clip_space, {64, 32});
    const projection reversed(glm::mat4(1.0f), godot_clip_space, {64, 32});
    CHECK(p.outside({0, 0, 0, 1}) == 0u);
    CHECK(p.outside({guard_band, -guard_band, 9, 1}) == 0u);  // borders are inside, and there is no far plane
    CHECK(p.outside({0, 0, -1e-30, 1}) == 1u << 1);
    CHECK(reversed.outside({0, 0, -9, 1}) == 0u);
    CHECK(reversed.outside({0, 0, 1, 1}) == 0u);
    CHECK(reversed.outside({0, 0, 1.0000001, 1}) == 1u << 1);
    CHECK(p.outside({-guard_band - 1, 0, 0, 1}) == 1u << 2);
    CHECK(p.outside({guard_band + 1, 0, 0, 1}) == 1u << 3);
    CHECK(p.outside({0, -guard_band - 1, 0, 1}) == 1u << 4);
    CHECK(p.outside({0, guard_band + 1, 0, 1}) == 1u << 5);
    CHECK((p.outside({0, 0, 0, 0}) & 1u) == 1u);
    CHECK((p.outside({0, 0, 0, -1}) & 1u) == 1u);
}

TEST_CASE("projection: a block of positions lands where each one does alone") {
    std::mt19937 random(11);
    const auto real = [&](float low, float high) { return low + (high - low) * float(random() >> 8) * 0x1p-24f; };
    glm::mat4 no_near(0.0f);  // clip coordinates x, y, 1/4, z: only w > 0 bounds what is near
    no_near[0][0] = no_near[1][1] = no_near[2][3] = 1.0f, no_near[3][2] = 0.25f;
    int inside = 0, outside = 0, wrong = 0;
    for (int round = 0; round < 4000; ++round) {
        glm::mat4 m;
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = real(-1, 1) * (round % 3 ? 1.0f : round % 2 ? 1e30f : 1e-30f);
        if (round % 4 == 0) m = no_near;
        const clip_space clip{.range = round & 1 ? depth_range::minus_one_to_one : depth_range::zero_to_one,
                              .direction = round & 2 ? depth_direction::reversed : depth_direction::forward};
        const projection p(m, clip, {random() % 4000u, random() % 4000u});
        glm::vec3 positions[block];
        for (auto& position : positions) {
            const float reach = random() % 4 ? 1.0f : 1e6f;
            for (int k = 0; k < 3; ++k) position[k] = random() % 8 ? real(-reach, reach) : float(int(random() % 3) - 1);
        }
        for (const auto& position : positions) ++(p.outside(p.homogeneous(position)) ? outside : inside);
        for_each_isa([&] {
            snapped_vertex vertices[block];
            p.snap(positions, vertices);
            for (int i = 0; i < block; ++i) {
                const auto h = p.homogeneous(positions[i]);
                const unsigned planes = p.outside(h);
                wrong += planes_outside(vertices[i]) != planes || (!planes && vertices[i] != p.snap(h));
            }
        });
    }
    CHECK(wrong == 0);
    CHECK(inside > 17000);
    CHECK(outside > 17000);
}
