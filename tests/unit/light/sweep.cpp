// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include <umbrage/light/sweep.hpp>

#include "../rounds.hpp"
#include "bodies.hpp"

using namespace umbrage;

TEST_CASE("convex_hull: by hand, and of points that have none") {
    using points = std::vector<glm::dvec3>;
    using corners = std::vector<glm::dvec2>;
    CHECK(detail::convex_hull(points{{0, 0, 1}, {2, 0, 2}, {1, 0, 3}, {2, 2, 4}, {1, 1, 0}, {0, 2, 0}, {2, 0, 9}}) ==
          corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    CHECK(detail::convex_hull(points{{1, 1, 0}, {3, 2, 0}, {5, 3, 0}}) == corners{{1, 1}, {5, 3}});
    CHECK(detail::convex_hull(points{{1, 1, 0}}).size() <= 1);
    CHECK(detail::convex_hull(points{{1, 1, 0}, {1, 1, 5}}).size() <= 2);
}

TEST_CASE("clipped_hull: reaches as far as a box's clipped faces in every direction, whatever the points between") {
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) {
        const auto box = bodies::random_box(random, i % 5 == 0);
        const glm::dvec3 normal = i % 4 ? bodies::random_vector(random, -1, 1) : glm::dvec3(0, 0, i % 8 ? 1 : -1);
        auto points = hull(box).points;
        const glm::dvec4 plane(normal, -glm::dot(normal, bodies::point_between(points, random)));
        for (int k = 0; k < (i % 50 == 1 ? 200 : i % 20); ++k) points.push_back(bodies::point_between(points, random));
        const polyhedron body(box);
        std::vector<glm::dvec3> expected;
        for (const auto& face : body.faces())
            for (const glm::dvec3& p : detail::clipped(face.corners, plane)) expected.push_back(p);
        const auto found = detail::clipped_hull(points, plane);
        REQUIRE(found.empty() == expected.empty());
        const auto reach = [](const std::vector<glm::dvec3>& of, glm::dvec3 way) {
            double most = -1e9;
            for (const glm::dvec3& p : of) most = std::max(most, glm::dot(p, way));
            return most;
        };
        double apart = 0;
        for (int k = 0; k < 50; ++k) {
            const glm::dvec3 way = bodies::random_vector(random, -1, 1);
            apart = std::max(apart, std::abs(reach(found, way) - reach(expected, way)));
        }
        CHECK(apart < 1e-12);
    }
    const std::vector<glm::dvec3> one{{1, 2, 3}}, two{{0, 0, -1}, {2, 4, 1}};
    CHECK(detail::clipped_hull(one, {0, 0, 1, 0}) == one);
    CHECK(detail::clipped_hull(one, {0, 0, 1, -4}).empty());
    CHECK(detail::clipped_hull(two, {0, 0, 1, 0}) == std::vector<glm::dvec3>{{2, 4, 1}, {1, 2, 0}});
}

TEST_CASE("convex_hull, sides: every point within, every corner one of them") {
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        std::vector<glm::dvec3> points(std::size_t(3 + i % 40));
        for (auto& p : points) p = bodies::random_vector(random, -5, 5);
        if (i % 2)  // each face of a body has its corners rounded its own way
            for (std::size_t k = 0, n = points.size(); k < 3 * n; ++k)
                points.push_back(points[k % n] + bodies::random_vector(random, -1e-15, 1e-15));
        const auto hull = detail::convex_hull(points);
        CHECK(hull.size() >= 3);
        for (const auto& corner : hull)
            CHECK(std::any_of(points.begin(), points.end(), [&](const auto& p) { return glm::dvec2(p) == corner; }));
        for (double outwards : {0.0, 0.5}) {
            const auto planes = outwards > 0 ? detail::sweep(points, outwards) : detail::sides(hull);
            double least = 1e9;
            for (const auto& plane : planes) {
                double within = 1e9;
                for (const auto& p : points) within = std::min(within, glm::dot(plane, glm::dvec4(p.x, p.y, p.z, 1)));
                const double share = std::abs(plane.x) + std::abs(plane.y);  // of a square's corner
                CHECK(within > outwards * share - 1e-12);
                least = std::min(least, within / glm::length(glm::dvec2(plane)));
            }
            CHECK(least == doctest::Approx(outwards));
        }
    }
}

TEST_CASE("sweep: does not jump where a corner splits in two, holds what touches its sides") {
    const glm::dmat4 frame(1.0);
    const bounding_box<double> caster{{-0.9, -0.9, -3}, {-0.9, -0.9, -2}};
    const std::vector<glm::dvec3> whole{{0, 0, 0}, {10, 9, 0}, {9, 10, 0}};
    const std::vector<glm::dvec3> split{{1e-6, 0, 0}, {0, 1e-6, 0}, {10, 9, 0}, {9, 10, 0}};
    CHECK(detail::nearest(frame, caster, detail::sweep(whole, 1.0)) == -3);
    CHECK(detail::nearest(frame, caster, detail::sweep(split, 1.0)) == -3);
    std::mt19937 random(4);
    int lost = 0;
    for (int i = 0; i < 1000; ++i) {
        std::vector<glm::dvec3> points;
        for (int k = 0; k < 5; ++k) points.push_back(bodies::random_vector(random, -5, 5));
        for (const auto& plane : detail::sweep(points, 0.0))
            for (const auto& p : points) lost += glm::dot(plane, glm::dvec4(p, 1)) < 0;
    }
    CHECK(lost == 0);
}

TEST_CASE("convex_hull: holds corners that are repeated up to rounding") {
    const auto outside = [](const std::vector<glm::dvec3>& points) {
        double farthest = 0;
        for (const auto& side : detail::sides(detail::convex_hull(points)))
            for (const auto& p : points)
                farthest = std::max(farthest, -glm::dot(side, glm::dvec4(p, 1)) / glm::length(glm::dvec2(side)));
        return farthest;
    };
    CHECK(outside({{1.0791274728253482, -0.83726838789880298, 0},
                   {1.0791274728253477, -0.83726838789880309, 0},
                   {1.6440862612798803, -0.62520269211381663, 0},
                   {-1.1595047703012828, -1.839826149865984, 0}}) < 1e-12);
    std::mt19937 random(3);
    bodies::real near_zero(-1e-15, 1e-15), anywhere(-2, 2);
    double farthest = 0;
    for (int i = 0; i < rounds(200000); ++i) {
        std::vector<glm::dvec3> points;
        for (int corner = 0; corner < 3 + i % 6; ++corner) {
            const glm::dvec2 p(anywhere(random), anywhere(random));
            for (int copy = 0; copy < 3; ++copy)
                points.emplace_back(p.x + near_zero(random), p.y + near_zero(random), 0.0);
        }
        farthest = std::max(farthest, outside(points));
    }
    CHECK(farthest < 1e-12);
}

TEST_CASE("nearest: of a box before, beside and around a square") {
    const glm::dmat4 frame(1.0);
    const auto planes = detail::sweep({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0.0);
    const auto of = [&](glm::dvec3 low, glm::dvec3 high) {
        return detail::nearest(frame, bounding_box<double>{low, high}, planes);
    };
    CHECK(of({-5, -5, 3}, {5, 5, 4}) == 3);
    CHECK(of({0.5, 0.5, -3}, {0.6, 5, 4}) == -3);
    CHECK(of({2, -5, -3}, {5, 5, 4}) == detail::highest<double>);
}
