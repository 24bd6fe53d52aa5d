// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <random>

#include <umbrage/light/sweep.hpp>

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
            double least = 1e9;
            for (const auto& plane : detail::sides(hull, outwards)) {
                double within = 1e9;
                for (const auto& p : points) within = std::min(within, glm::dot(plane, glm::dvec4(p.x, p.y, p.z, 1)));
                CHECK(within > outwards * glm::length(glm::dvec2(plane)) - 1e-12);
                least = std::min(least, within / glm::length(glm::dvec2(plane)));
            }
            CHECK(least == doctest::Approx(outwards));
        }
    }
}

TEST_CASE("nearest: of a box before, beside and around a square") {
    const glm::dmat4 frame(1.0);
    const auto planes = detail::sweep({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 0.0);
    const auto of = [&](glm::dvec3 low, glm::dvec3 high) {
        return detail::nearest(frame, bounding_box<double>{low, high}, planes);
    };
    CHECK(of({-5, -5, 3}, {5, 5, 4}) == 3);
    CHECK(of({0.5, 0.5, -3}, {0.6, 5, 4}) == -3);
    CHECK(of({2, -5, -3}, {5, 5, 4}) == std::numeric_limits<double>::infinity());
}
