// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/bias/distance_slope.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/light/point/dual_paraboloid.hpp>

using namespace umbrage;

TEST_CASE("dual_paraboloid_slope: no texel's step of a plane changes distance by more, and some by nearly as much") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    const double inner = 512, range = 20;
    double nearest = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
        const glm::dvec3 way = 5.0 * glm::normalize(glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
        if (std::abs(glm::dot(normal, glm::normalize(way))) < 0.2 || std::abs(way.z) < 0.2) continue;
        const glm::dvec2 slope = dual_paraboloid_slope(way, normal, 2.0 / (range * inner));
        const glm::dvec3 one = glm::normalize(glm::cross(normal, way)), other = glm::cross(normal, one);
        double found = 0;
        for (int turn = 0; turn < 64; ++turn) {
            const double angle = turn * 0.0982;
            const glm::dvec3 there = way + (one * std::cos(angle) + other * std::sin(angle)) * 1e-5;
            const double texels =
                glm::length(glm::dvec2(dual_paraboloid_coordinate(there) - dual_paraboloid_coordinate(way))) * inner;
            found = std::fmax(found, std::abs(glm::length(there) - glm::length(way)) / range / texels);
        }
        CHECK(found <= std::sqrt(2.0) * slope.x * 1.001);
        nearest = std::fmax(nearest, found / (std::sqrt(2.0) * slope.x));
    }
    CHECK(nearest > 0.99);
}

TEST_CASE("dual_paraboloid_slope: edges") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const glm::vec3 up(0, 1, 0), way(0, -3, 4);
    CHECK(dual_paraboloid_slope(way, glm::vec3(0), 0.01f) == glm::vec2(0));
    CHECK(dual_paraboloid_slope(glm::vec3(0, 0, 4), up, 0.01f) == glm::vec2(2));  // edge-on
    CHECK(dual_paraboloid_slope(way, glm::vec3(nan, 0, 0), 0.01f) == glm::vec2(2));
    CHECK(dual_paraboloid_slope(glm::vec3(0, -4, 0), up, 0.01f) == glm::vec2(0));  // faces the light
    CHECK(dual_paraboloid_slope(way, up * 7.0f, 0.01f).x == doctest::Approx(dual_paraboloid_slope(way, up, 0.01f).x));
}
