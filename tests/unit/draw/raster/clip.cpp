// SPDX-License-Identifier: MIT
#include <umbrage/draw/raster/clip.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>

using namespace umbrage;
using namespace umbrage::detail;

namespace {

// clip coordinates x, y, 1/4, z: only w > 0 bounds what is near
glm::mat4 no_near() {
    glm::mat4 m(0.0f);
    m[0][0] = m[1][1] = m[2][3] = 1.0f, m[3][2] = 0.25f;
    return m;
}

}  // namespace

TEST_CASE("clip_triangle: a corner at the eye is cut off where w is still positive") {
    const projection p(no_near(), cpu_clip_space, {64, 64});
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
    const projection p(m, cpu_clip_space, {64, 64});
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
