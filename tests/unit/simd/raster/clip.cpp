// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <stdexcept>

#include <umbrage/simd/raster/clip.hpp>

using namespace umbrage;
using detail::best_isa;
using detail::isa;

namespace {

// clip coordinates x, y, 1/4, z: only w > 0 bounds what is near
glm::mat4 no_near() {
    glm::mat4 m(0.0f);
    m[0][0] = m[1][1] = m[2][3] = 1.0f, m[3][2] = 0.25f;
    return m;
}

}  // namespace

TEST_CASE("projection: homogeneous texels and depth, for each depth range") {
    const projection p(glm::mat4(1.0f), opengl_clip_space, {64, 32});
    CHECK(p.homogeneous({-1, -1, -1}) == glm::dvec4(0, 0, 0, 1));
    CHECK(p.homogeneous({1, 0.5f, 0.5f}) == glm::dvec4(64, 24, 0.75, 1));
    CHECK(projection(glm::mat4(1.0f), {}, {64, 32}).homogeneous({1, 0.5f, 0.5f}) == glm::dvec4(64, 24, 0.5, 1));
    CHECK_THROWS_AS(projection(glm::mat4(1.0f), {}, {-1, 1}), std::invalid_argument);
    CHECK_THROWS_AS(projection(glm::mat4(1.0f), {}, {1, guard_band + 1}), std::invalid_argument);
}

TEST_CASE("projection: snaps to 1/256 texel, halves upwards, on either side of 0") {
    const projection p(glm::mat4(1.0f), {}, {1, 1});
    const auto column = [&](double steps) { return p.snap({steps * 3.0 / 256.0, 0.0, 0.0, 3.0}).x; };
    for (int i = -1000; i <= 1000; ++i) {
        CHECK(column(i) == i);
        CHECK(column(i - 0.5) == i);
        CHECK(column(i - 0.625) == i - 1);
        CHECK(column(i + 0.375) == i);
    }
}

TEST_CASE("projection: what each plane keeps out") {
    const projection p(glm::mat4(1.0f), {}, {64, 32});
    const projection reversed(glm::mat4(1.0f), {.direction = depth_direction::reversed}, {64, 32});
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

TEST_CASE("clip_triangle: a corner at the eye is cut off where w is still positive") {
    const projection p(no_near(), {}, {64, 64});
    const auto at = [&](float x, float y, float z) { return p.homogeneous({x, y, z}); };
    const auto polygon = clip_triangle(p, at(0, 0, 0), at(-1, -1, 1), at(1, -1, 1));
    CHECK(polygon.count == 4);
    for (int i = 0; i < polygon.count; ++i) {
        CHECK(is_finite(polygon.vertices[std::size_t(i)].depth));
        CHECK(polygon.vertices[std::size_t(i)].y == 0);  // edge-on: it all lies on the lower border
    }
    CHECK(p.cut(1, {0, 0, 1e-30, 1e38}, {0, 0, -1e-60, 0x1p-126}).w > 0.0);  // where rounding would leave nothing
}

TEST_CASE("clip_triangle: the same polygon for any order of corners, within the guard band, smallest first") {
    std::mt19937 random(7);
    const auto coordinate = [&] { return double(int(random() % 2001) - 1000) * 64.0; };
    glm::mat4 m(1.0f);
    m[2][3] = 1.0f, m[3][3] = 0.0f;  // w = z
    const projection p(m, {}, {64, 64});
    int most = 0, none = 0;
    for (int round = 0; round < 2000; ++round) {
        std::array<glm::dvec4, 3> h;
        for (auto& c : h) c = {coordinate() * 20.0, coordinate() * 20.0, coordinate(), coordinate() / 64.0};
        const auto reference = clip_triangle(p, h[0], h[1], h[2]);
        most = std::max(most, reference.count), none += reference.count == 0;
        const auto last = reference.vertices.begin() + reference.count;
        if (reference.count) CHECK(std::min_element(reference.vertices.begin(), last) == reference.vertices.begin());
        for (auto v = reference.vertices.begin(); v != last; ++v) {
            CHECK(std::max({v->x, v->y, -v->x, -v->y}) <= guard_band * subtexels);
            CHECK(v->depth >= 0.0);
        }
        constexpr int orders[5][3] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        for (const auto& order : orders) {
            auto other = clip_triangle(p, h[std::size_t(order[0])], h[std::size_t(order[1])], h[std::size_t(order[2])]);
            REQUIRE(other.count == reference.count);
            const bool other_way_round = &order >= &orders[2] && other.count > 0;
            if (other_way_round) std::reverse(other.vertices.begin() + 1, other.vertices.begin() + other.count);
            CHECK(std::equal(reference.vertices.begin(), last, other.vertices.begin()));
        }
    }
    CHECK(most >= 6);
    CHECK(none > 100);
    CHECK(none < 1900);
}

TEST_CASE("projection: a block of positions lands where each one does alone") {
    std::mt19937 random(11);
    const auto in_use = detail::isa_in_use;
    const auto real = [&](float low, float high) { return low + (high - low) * float(random() >> 8) * 0x1p-24f; };
    int inside = 0, outside = 0, wrong = 0;
    for (int round = 0; round < 4000; ++round) {
        glm::mat4 m;
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = real(-1, 1) * (round % 3 ? 1.0f : round % 2 ? 1e30f : 1e-30f);
        if (round % 4 == 0) m = no_near();
        const clip_space clip{.range = round & 1 ? depth_range::minus_one_to_one : depth_range::zero_to_one,
                              .direction = round & 2 ? depth_direction::reversed : depth_direction::forward};
        const projection p(m, clip, {random() % 4000u, random() % 4000u});
        glm::vec3 positions[detail::block];
        for (auto& position : positions) {
            const float reach = random() % 4 ? 1.0f : 1e6f;
            for (int k = 0; k < 3; ++k) position[k] = random() % 8 ? real(-reach, reach) : float(int(random() % 3) - 1);
        }
        for (isa set : {isa::base, isa::avx2, isa::avx512}) {
            detail::isa_in_use = std::min(set, best_isa());
            snapped_vertex vertices[detail::block];
            p.snap(positions, vertices);
            for (int i = 0; i < detail::block; ++i) {
                const auto h = p.homogeneous(positions[i]);
                const unsigned planes = p.outside(h);
                ++(planes ? outside : inside);
                wrong += planes_outside(vertices[i]) != planes || (!planes && vertices[i] != p.snap(h));
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(inside > 50000);
    CHECK(outside > 50000);
    detail::isa_in_use = in_use;
}
