// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/dual_paraboloid.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../clip_spaces.hpp"
#include "../directions.hpp"

using namespace umbrage;

TEST_CASE("dual_paraboloid_coordinate: every direction within its map's circle, and back") {
    std::mt19937 random(1);
    int outside = 0;
    double apart = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 d = glm::normalize(directions::any(random)), at = dual_paraboloid_coordinate(d);
        const glm::dvec2 p = 2.0 * glm::dvec2(at) - 1.0;
        const double r = glm::dot(p, p), turn = at.z == 0 ? -1 : 1;
        outside += !(r <= 1 + 1e-12) || at.z != (d.z < 0 ? 1 : 0);
        const glm::dvec3 back = glm::dvec3(turn * 2 * p.x, 2 * p.y, -turn * (1 - r)) / (1 + r);
        apart = worse(apart, glm::distance(back, d));
    }
    CHECK(outside == 0);
    CHECK(apart < 1e-14);
}

TEST_CASE("dual_paraboloid_coordinate: the way round that a right-handed view shows, over the seam at 1 - s") {
    for (const double forward : {1.0, -1.0}) {
        const glm::dvec3 f(0, 0, forward), up(0, 1, 0), right = glm::cross(f, up);
        CHECK(dual_paraboloid_coordinate(f + 0.1 * right).x > 0.5);
        CHECK(dual_paraboloid_coordinate(f + 0.1 * up).y > 0.5);
    }
    for (int i = 0; i < 360; ++i) {
        const double turn = i * std::numbers::pi / 180;
        const glm::dvec3 front = dual_paraboloid_coordinate(glm::dvec3(std::cos(turn), std::sin(turn), 1e-9));
        const glm::dvec3 behind = dual_paraboloid_coordinate(glm::dvec3(std::cos(turn), std::sin(turn), -1e-9));
        CHECK(std::abs(front.x + behind.x - 1) < 1e-8);
        CHECK(std::abs(front.y - behind.y) < 1e-8);
    }
}

TEST_CASE("dual_paraboloid_coordinate: by hand; no direction, or a NaN, is lit") {
    CHECK(dual_paraboloid_coordinate(glm::vec3(0, 0, 2)) == glm::vec3(0.5f, 0.5f, 0));
    CHECK(dual_paraboloid_coordinate(glm::vec3(0, 0, -2)) == glm::vec3(0.5f, 0.5f, 1));
    CHECK(dual_paraboloid_coordinate(glm::vec3(3, 0, 4)) == glm::vec3((9 - 3) / 18.0f, 0.5f, 0));
    CHECK(dual_paraboloid_coordinate(glm::vec3(3, 0, -4)) == glm::vec3((9 + 3) / 18.0f, 0.5f, 1));
    const image<float> map({4, 4}, 0.0f);
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    for (const glm::vec3 bad : {glm::vec3(0), glm::vec3(nan, 0, 1), glm::vec3(0, 0, nan), glm::vec3(infinity)}) {
        const glm::vec3 at = dual_paraboloid_coordinate(bad);
        CHECK((at.z == 0 || at.z == 1));
        CHECK(hard(clamped(map), glm::vec2(at) * 4.0f, 0.5f) == 1.0f);
    }
}

TEST_CASE(
    "dual_paraboloid_coordinate: texels in the middle hold 4 times what those at the rim do; 8 n^2 of them are as "
    "dense as a cube's 6 n^2") {
    const double middle = directions::solid_angle({0, 0, 1}, dual_paraboloid_coordinate<double>);
    const double rim = directions::solid_angle({0.6, 0.8, 1e-4}, dual_paraboloid_coordinate<double>);
    CHECK(middle / rim == doctest::Approx(4).epsilon(1e-3));
    const double cube_middle = 4;  // of a face, whose s and t are half of tangents
    CHECK(2 * middle / cube_middle == doctest::Approx(8).epsilon(1e-6));
}

TEST_CASE(
    "make_dual_paraboloid_light: vertices land on dual_paraboloid_coordinate's texels with distance_depth, in "
    "every convention, and behind the rim within the border") {
    std::mt19937 random(2);
    for (const clip_space clip : all_clip_spaces())
        for (const int border : {0, 3}) {
            CAPTURE(to_string(clip));
            const glm::dvec3 position(3, -2, 7);
            const auto light = make_dual_paraboloid_light<double>(
                {.position = position, .range = 40, .map_size = 64, .border = border, .clip = clip});
            const glm::dmat4 to_texels = texture_matrix<double>({glm::dmat4(1), light.projection, clip}, {64, 64});
            double apart = 0;
            for (int i = 0; i < 2000; ++i) {
                const glm::dvec3 direction = 5.0 * directions::any(random), at = dual_paraboloid_coordinate(direction);
                const glm::dvec3 seen(light.view * glm::dvec4(position + direction, 1));
                const glm::dvec4 h = to_texels * dual_paraboloid_position(seen, at.z);
                double depth = distance_depth(direction, 1.0 / 40);
                if (clip.direction == depth_direction::reversed) depth = 1 - depth;
                const glm::dvec3 expected(glm::dvec2(at) * (64.0 - 2 * border) + double(border), depth);
                for (glm::length_t k = 0; k < 3; ++k) apart = worse(apart, std::abs(h[k] / h.w - expected[k]));
            }
            CHECK(apart < 1e-9);
        }
    const auto light = make_dual_paraboloid_light<double>({.map_size = 64, .border = 4, .clip = cpu_clip_space});
    const glm::dvec4 corner = light.projection * dual_paraboloid_position(glm::dvec3(-9, 0, -1.2), 0.0);
    CHECK(corner.x / corner.w < 1);  // 7.6 degrees behind the rim, 8/7 of the circle's radius
    CHECK(corner.x / corner.w > 0.98);
}

TEST_CASE("paraboloid_edge_angle: edges at the rim are half a texel off, untessellated ones 17, 69 and 150 texels") {
    constexpr double degree = std::numbers::pi / 180;
    CHECK(paraboloid_edge_angle<double>(512, 0) == doctest::Approx(7.2 * degree).epsilon(0.01));
    CHECK(paraboloid_edge_angle<double>(1024, 0) == doctest::Approx(5.1 * degree).epsilon(0.01));
    CHECK(paraboloid_edge_angle<double>(2048, 0) == doctest::Approx(3.6 * degree).epsilon(0.01));
    CHECK(paraboloid_edge_angle(512) == paraboloid_edge_angle(512, dual_paraboloid_light<float>{}.border));
    for (const glm::ivec2 none : {glm::ivec2(4, 2), {2, 8}}) CHECK(is_nan(paraboloid_edge_angle(none.x, none.y)));
    const auto off = [](double angle, int size) {  // of an edge along the rim
        const auto texel = [&](double turn) {
            return glm::dvec2(dual_paraboloid_coordinate(glm::dvec3(std::cos(turn), std::sin(turn), 0))) * double(size);
        };
        return glm::distance(texel(angle / 2), (texel(0) + texel(angle)) / 2.0);
    };
    for (const int size : {256, 512, 1024, 2048})
        CHECK(off(paraboloid_edge_angle<double>(size, 0), size) == doctest::Approx(0.5).epsilon(0.002));
    for (const int border : {2, 8, 64}) {  // at a kernel's corner in a diagonal, a tangent of that circle
        constexpr double size = 512;
        const double inner = size - 2 * border, rim = 1 + 2 * std::numbers::sqrt2 * border / inner;
        const glm::dvec3 corner = glm::dvec3(2 * rim, 0, 1 - rim * rim) / (1 + rim * rim), across(0, 1, 0);
        const auto texel = [&](double turn) {
            const glm::dvec4 h = dual_paraboloid_position(corner * std::cos(turn) + across * std::sin(turn), 0.0);
            return glm::dvec2(h) / h.w * (inner / 2);
        };
        const double half = paraboloid_edge_angle<double>(static_cast<int>(size), border) / 2;
        CAPTURE(border);
        CHECK(glm::length(texel(0)) == doctest::Approx(inner / 2 + std::numbers::sqrt2 * border));
        CHECK(glm::distance(texel(0), (texel(-half) + texel(half)) / 2.0) <= 0.5);
        CHECK(glm::distance(texel(0), (texel(-half) + texel(half)) / 2.0) > 0.4);
    }
    CHECK(off(30 * degree, 1024) == doctest::Approx(17).epsilon(0.03));
    CHECK(off(60 * degree, 1024) == doctest::Approx(69).epsilon(0.01));
    CHECK(off(90 * degree, 1024) == doctest::Approx(150).epsilon(0.002));
}

TEST_CASE("make_dual_paraboloid_light: what is wrong is named") {
    using light = dual_paraboloid_light<float>;
    const auto of = [](auto change) {
        light l{.clip = cpu_clip_space};
        change(l);
        const std::string message = complaint([&] { (void)make_dual_paraboloid_light(l); });
        const auto begin = message.find(": ");
        return message.empty() ? message : message.substr(begin + 2, message.find(" must") - begin - 2);
    };
    CHECK(of([](light&) {}).empty());
    CHECK(of([](light& l) { l.map_size = 16, l.border = 2; }).empty());
    CHECK(of([](light& l) { l.map_size = 15; }) == "map_size");
    CHECK(of([](light& l) { l.border = -1; }) == "border");
    CHECK(of([](light& l) { l.border = 65; }) == "border");
    CHECK(of([](light& l) { l.border = std::numeric_limits<int>::max(); }) == "border");
    CHECK(of([](light& l) { l.range = 0; }) == "range");
    CHECK(of([](light& l) { l.range = std::numeric_limits<float>::infinity(); }) == "range");
    CHECK(of([](light& l) { l.range = std::nanf(""); }) == "range");
    CHECK(of([](light& l) { l.range = 1e-39f; }) == "range");
    CHECK(of([](light& l) { l.position.y = std::nanf(""); }) == "position");
}
