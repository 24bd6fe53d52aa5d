// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/draw/tessellate.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <umbrage/light/point/dual_paraboloid.hpp>

#include "../light/clip_spaces.hpp"
#include "../special_values.hpp"

using namespace umbrage;

namespace {

/// Two triangles beside each other with positions of their own, one of them the other way round.
const std::vector<glm::vec3> two_corners{{-6, 1, 2}, {5, 0.5f, 3}, {1, -4, 9}, {1, -4, 9}, {5, 0.5f, 3}, {8, -7, 1}};
const std::vector<glm::uvec3> two_triangles{{0, 1, 2}, {5, 3, 4}};
const mesh_view two{two_corners, two_triangles};

glm::dvec3 corner(const tessellated_mesh& m, const glm::uvec3& t, glm::length_t i) {
    return glm::dvec3(m.positions[t[i % 3]]);
}
glm::dvec3 area(const tessellated_mesh& m, const glm::uvec3& t) {
    return glm::cross(corner(m, t, 1) - corner(m, t, 0), corner(m, t, 2) - corner(m, t, 0)) / 2.0;
}

/// Height of an arc over its chord, in a map of some texels.
double height_over_chord(glm::dvec3 p, glm::dvec3 q, int texels) {
    const auto place = [&](glm::dvec3 d) {
        const glm::dvec4 h = dual_paraboloid_position(d, 0.0);
        return glm::dvec2(h) / h.w * (texels / 2.0);
    };
    const glm::dvec2 a = place(p), way = glm::normalize(place(q) - a);
    double greatest = 0;
    for (int i = 1; i < 64; ++i) {
        const glm::dvec2 off = place(glm::mix(p, q, i / 64.0)) - a;
        greatest = worse(greatest, std::abs(off.x * way.y - off.y * way.x));
    }
    return greatest;
}

}  // namespace

TEST_CASE("tessellate: the same surface, without gaps, edges below the angle and distances within the error") {
    const tessellation to{.position = {0.2f, -0.1f, 0.3f}, .angle = 0.2f, .range = 12, .depth_error = 1.0f / 1024};
    const tessellated_mesh cut = tessellate(two, to);
    const glm::dvec3 light(to.position);
    CHECK(cut.triangles.size() > 50);
    std::map<std::vector<float>, int> edges;  // by their ends' positions
    glm::dvec3 sum(0);
    double widest = 0, sag = 0;
    for (const glm::uvec3& t : cut.triangles) {
        sum += area(cut, t);
        for (glm::length_t i = 0; i < 3; ++i) {
            const glm::vec3 a = cut.positions[t[i]], b = cut.positions[t[(i + 1) % 3]];
            const bool swapped = std::tuple(b.x, b.y, b.z) < std::tuple(a.x, a.y, a.z);
            const glm::vec3 low = swapped ? b : a, high = swapped ? a : b;
            ++edges[{low.x, low.y, low.z, high.x, high.y, high.z}];
            const glm::dvec3 p = glm::dvec3(a) - light, q = glm::dvec3(b) - light;
            const double cosine = glm::dot(p, q) / (glm::length(p) * glm::length(q));
            widest = worse(widest, std::acos(std::min(cosine, 1.0)));
            const double half = std::sqrt((1 + cosine) / 2), both = glm::length(p) + glm::length(q);
            sag = worse(sag, both / 2 - 2 * glm::length(p) * glm::length(q) * half / both);
        }
    }
    int alone = 0;
    double rim = 0, whole_rim = 0;
    for (const auto& [ends, times] : edges) {
        CHECK(times <= 2);
        alone += times == 1;
        if (times == 1)
            rim += glm::distance(glm::dvec3(ends[0], ends[1], ends[2]), glm::dvec3(ends[3], ends[4], ends[5]));
    }
    for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {2, 5}, {1, 5}})  // not the edge that both share
        whole_rim += glm::distance(glm::dvec3(two_corners[std::size_t(a)]), glm::dvec3(two_corners[std::size_t(b)]));
    CHECK(alone > 20);
    CHECK(rim == doctest::Approx(whole_rim).epsilon(1e-6));
    const tessellated_mesh whole{two_corners, two_triangles};
    CHECK(glm::distance(sum, area(whole, two_triangles[0]) + area(whole, two_triangles[1])) < 1e-4);
    CHECK(widest <= 0.2 + 1e-6);
    CHECK(widest > 0.1);
    CHECK(sag <= 12.0 / 1024);
    CHECK(sag > 2.0 / 1024);
}

TEST_CASE("tessellate: a paraboloid map of 1024 texels has no edge more than half a texel off, and some a quarter") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-1, 1);
    double greatest = 0, before = 0;
    for (int n = 0; n < 40; ++n) {
        std::vector<glm::vec3> corners;
        while (corners.size() < 3) {
            const float x = real(random), y = real(random), z = real(random) * 0.5f + 0.45f;
            corners.push_back(3.0f * glm::vec3(x, y, z));
        }
        const std::vector<glm::uvec3> triangle{{0, 1, 2}};
        const tessellated_mesh cut = tessellate({corners, triangle}, {.angle = paraboloid_edge_angle(1024, 0)});
        const auto both_seen = [](glm::dvec3 p, glm::dvec3 q) { return p.z >= 0 && q.z >= 0; };
        for (const glm::uvec3& t : cut.triangles)
            for (glm::length_t i = 0; i < 3; ++i)
                if (const auto p = corner(cut, t, i), q = corner(cut, t, i + 1); both_seen(p, q))
                    greatest = worse(greatest, height_over_chord(p, q, 1024));
        if (both_seen(corners[0], corners[1])) before = worse(before, height_over_chord(corners[0], corners[1], 1024));
    }
    CHECK(greatest <= 0.5);
    CHECK(greatest > 0.25);
    CHECK(before > 100);
}

TEST_CASE("tessellate: small and wholly distant triangles stay, as do those that are not finite or hold the light") {
    const auto count = [](const std::vector<glm::vec3>& corners, const tessellation& to) {
        const std::vector<glm::uvec3> triangle{{0, 1, 2}};
        return tessellate({corners, triangle}, to).triangles.size();
    };
    CHECK(count({{0, 0, 9}, {0.1f, 0, 9}, {0, 0.1f, 9}}, {}) == 1);
    CHECK(count({{0, 0, 90}, {5, 0, 190}, {0, 5, 90}}, {.range = 80}) == 1);
    CHECK(count({{0, 0, 90}, {5, 0, 190}, {0, 5, 90}}, {.range = 100}) > 1);
    CHECK(count({{0, 0, std::nanf("")}, {5, 0, 9}, {5.1f, 0, 9}}, {}) == 1);
    CHECK(count({{0, 0, inf32}, {5, 0, 9}, {5.1f, 0, 9}}, {}) == 1);
    CHECK(count({{0, 0, 0}, {5, 0, 9}, {5.1f, 0, 9}}, {}) >= 1);      // a corner in the light
    CHECK(count({{-5, -5, 0}, {5, -5, 0}, {0, 5, 0}}, {}) < 100000);  // its plane through the light
    CHECK(count({{-5, -5, -5}, {5, 5, 5}, {0, 5, 0}}, {}) < 100000);  // an edge through the light
    CHECK(count({{8, 7.4f, 1.7f}, {0.8f, 1.1f, 1.1f}, {8, -0.7f, 1.8e28f}},
                {.position = {8, 8, 8}, .angle = 0.9f, .range = 11, .depth_error = 0.1f}) < 1000);
    CHECK(count({{8, -1, -7.8f}, {0, 8, 8}, {-8, 3.4e38f, 1.8e28f}},  // where floats lack digits
                {.position = {0, 1.8e28f, 1}, .angle = 1.8f, .range = 19, .depth_error = 0.004f}) < 1000);
    CHECK(count({{8, 1.1f, -7.8f}, {0, 3.4e38f, 0}, {8, -1.1f, 8}},  // a middle that moves by a denormal alone
                {.position = {0, 3.4e38f, 8}, .angle = 3, .range = 30, .depth_error = 0.5f}) < 1000);
    CHECK(count({{1.06346703f, -7.99986172f, 3.40282347e38f},  // middles closer to the light than its digits
                 {1.84917282e28f, 1.12486076f, 1.09803867f},
                 {-7.96446133f, 0, 0}},
                {.position = {0, 0, 1.84917282e28f}, .angle = 1.79685068f, .range = 19, .depth_error = 0.285f}) < 1000);
    CHECK(tessellate({}, {}).triangles.empty());
}

TEST_CASE("tessellate: what is wrong is named") {
    const auto of = [](const tessellation& to) {
        const std::string message = complaint([&] { (void)tessellate(two, to); });
        return message.substr(message.find(": ") + 2, message.find(" must") - message.find(": ") - 2);
    };
    CHECK(of({.position = {0, nan32, 0}}) == "position");
    CHECK(of({.angle = 0}) == "angle");
    CHECK(of({.angle = nan32}) == "angle");
    CHECK(of({.range = -1}) == "range");
    CHECK(of({.range = inf32}) == "range");
    CHECK(of({.depth_error = 0}) == "depth_error");
    CHECK(of({.depth_error = 1}) == "depth_error");
    CHECK(of({.depth_error = nan32}) == "depth_error");
    const std::vector<glm::uvec3> beyond{{0, 1, 6}};
    CHECK_THROWS_AS((void)tessellate({two_corners, beyond}, {}), std::invalid_argument);
}
