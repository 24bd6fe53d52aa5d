// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/bounds.hpp>

#include "bodies.hpp"
#include "clip_spaces.hpp"

using namespace umbrage;

template <class Body>
concept gives_faces = requires(Body body) {
    static_cast<Body>(body).faces();
};
static_assert(gives_faces<const polyhedron&> && !gives_faces<polyhedron&&> && !gives_faces<const polyhedron&&>);

TEST_CASE("corners: of a box and of a frustum, by hand") {
    const auto box = corners(bounding_box<float>{{1, 2, 3}, {4, 5, 6}});
    CHECK(box[0] == glm::dvec3(1, 2, 3));
    CHECK(box[3] == glm::dvec3(4, 5, 3));
    CHECK(box[7] == glm::dvec3(4, 5, 6));
    const auto ahead = corners(frustum<double>{
        .position = {1, 1, 1}, .direction = {0, 0, -3}, .tan_half_x = 2, .tan_half_y = 0.5, .z_near = 1, .z_far = 4});
    CHECK(glm::length(ahead[0] - glm::dvec3(-1, 0.5, 0)) < 1e-15);
    CHECK(glm::length(ahead[7] - glm::dvec3(9, 3, -3)) < 1e-15);
    const auto down = corners(frustum<double>{.direction = {0, -1, 0}, .z_near = 0, .z_far = 1});  // along its up
    for (const glm::dvec3& c : down) CHECK(glm::abs(glm::abs(c.x) - glm::abs(c.y)) < 1e-15);
}

TEST_CASE("sphere_around: holds the corners, and no smaller one on the axis does") {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const auto f = bodies::random_frustum(random);
        const auto sphere = sphere_around(f);
        const auto all = corners(f);
        const auto farthest = [&](glm::dvec3 from) {
            double r = 0;
            for (const glm::dvec3& c : all) r = std::max(r, glm::length(c - from));
            return r;
        };
        CHECK(std::abs(farthest(sphere.center) - sphere.radius) < 1e-12 * sphere.radius);
        const glm::dvec3 step = glm::normalize(f.direction) * (1e-4 * sphere.radius);
        CHECK(farthest(sphere.center + step) > sphere.radius);
        CHECK(farthest(sphere.center - step) > sphere.radius);
    }
}

TEST_CASE("sphere_around: a camera that turns and moves keeps the radius to the bit") {
    std::mt19937 random(2);
    frustum<float> f{.tan_half_x = 0.8f, .tan_half_y = 0.45f, .z_near = 3, .z_far = 17};
    const double radius = sphere_around(f).radius;
    for (int i = 0; i < 100; ++i) {
        f.position = glm::vec3(bodies::random_vector(random, -3000, 3000));
        f.direction = glm::vec3(bodies::random_vector(random, -1, 1));
        CHECK(sphere_around(f).radius == radius);
    }
}

TEST_CASE("intersection: reaches as far as the linear programme over both bodies' planes, in any direction") {
    std::mt19937 random(3);
    int some = 0;
    for (int i = 0; i < 200; ++i) {
        const auto camera = bodies::random_frustum(random);
        const auto box = bodies::random_box(random, i % 5 == 0);
        const polyhedron common = intersection(camera, box), other_way = intersection(box, camera);
        bodies::programme<3> planes;
        bodies::inside(planes, polyhedron(camera));
        bodies::inside(planes, polyhedron(box));
        const glm::dvec3 way = bodies::random_vector(random, -1, 1);
        const std::optional<double> expected = planes.least({way.x, way.y, way.z});
        CHECK(common.empty() == !expected.has_value());
        CHECK(other_way.empty() == common.empty());
        if (!expected) continue;
        ++some;
        for (const polyhedron& body : {common, other_way}) {
            double reached = std::numeric_limits<double>::infinity();
            for (const glm::dvec3& p : hull(body).points) reached = std::min(reached, glm::dot(p, way));
            CHECK(std::abs(reached - *expected) < 1e-8);
        }
    }
    CHECK(some > 50);
    CHECK(intersection(polyhedron(), bounding_box<float>{}).empty());
}

TEST_CASE("intersection: a box's end far beyond the camera's view leaves the digits of what is seen") {
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const frustum<double> camera = bodies::random_frustum(random);
        const glm::dvec3 middle = camera.position + glm::normalize(camera.direction) * (camera.z_far * 0.5);
        const auto seen = [&](double end) {
            bounding_box<double> box{middle - 1.0, middle + 2.0};
            (i % 2 ? box.high : box.low)[i % 3] = i % 2 ? end : -end;
            return hull(intersection(camera, box)).points;
        };
        const auto distant = seen(1e17), near_by = seen(1e5);
        REQUIRE(!near_by.empty());
        REQUIRE(distant.size() == near_by.size());
        for (std::size_t k = 0; k < distant.size(); ++k) CHECK(glm::length(distant[k] - near_by[k]) < 1e-8);
    }
}

TEST_CASE("intersection: of three bodies in any order") {
    std::mt19937 random(4);
    for (int i = 0; i < 300; ++i) {
        const auto camera = bodies::random_frustum(random);
        const auto a = bodies::random_box(random, i % 3 == 0), b = bodies::random_box(random);
        const glm::dvec3 way = bodies::random_vector(random, -1, 1);
        const auto reach = [&](const polyhedron& body) {
            double least = std::numeric_limits<double>::infinity();
            for (const glm::dvec3& p : hull(body).points) least = std::min(least, glm::dot(p, way));
            return least;
        };
        const double one = reach(intersection(intersection(camera, a), b));
        const double another = reach(intersection(a, intersection(b, camera)));
        CHECK((one == another || std::abs(one - another) < 1e-9));
    }
}

TEST_CASE("hull: takes each kind of body") {
    const bounding_box<float> box{{0, 0, 0}, {1, 2, 3}};
    CHECK(hull(box).points.size() == 8);
    CHECK(hull(polyhedron(box)).points.size() == 24);
    CHECK(hull(frustum<float>{}).points.size() == 8);
    const hull ball(bounding_sphere<float>{{1, 2, 3}, 4});
    CHECK(ball.points == std::vector{glm::dvec3(1, 2, 3)});
    CHECK(ball.radius == 4);
    const std::vector<glm::vec3> points{{1, 0, 0}, {0, 1, 0}};
    CHECK(hull(points).points == hull(std::span<const glm::vec3>(points)).points);
    CHECK(hull().points.empty());
}

TEST_CASE_TEMPLATE("corners, sphere_around, polyhedron, hull: a frustum that is none, by its argument", T, float,
                   double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const auto with = [](auto change) {
        frustum<T> f;
        change(f);
        const std::string error = complaint([&] { (void)corners(f); });
        const auto of = [&](const std::string& function) {
            return error.empty() ? "" : "umbrage::" + function + error.substr(std::string("umbrage::corners").size());
        };
        CHECK(complaint([&] { (void)sphere_around(f); }) == of("sphere_around"));
        CHECK(complaint([&] { (void)polyhedron(f); }) == of("polyhedron"));
        const hull body(f);  // which a fit refuses
        const auto& fault = body.fault;
        CHECK(body.points.empty() == !error.empty());
        CHECK((error.empty() ? fault.member + fault.condition + fault.got
                             : "umbrage::corners: frustum." + fault.member + " must be " + fault.condition + "; got " +
                                   fault.got) == error);
        return error;
    };
    const std::string name = "umbrage::corners: frustum.";
    CHECK(with([](auto&) {}).empty());
    CHECK(with([](auto& f) { f.z_near = 0; }).empty());
    CHECK(with([](auto& f) { f.up = f.direction; }).empty());
    for (T bad : {T(0), T(-1), nan, infinity}) {  // from 180 degrees on the tangent is infinite or negative
        CHECK(with([&](auto& f) { f.tan_half_x = bad; }).starts_with(name + "tan_half_x "));
        CHECK(with([&](auto& f) { f.tan_half_y = bad; }).starts_with(name + "tan_half_y "));
    }
    // the widest: sides that are farther away leave no digits of the scene
    CHECK(with([](auto& f) { f.tan_half_x = f.tan_half_y = f.shift.x = f.shift.y = 0x1p20f; }).empty());
    CHECK(with([](auto& f) { f.half_size = glm::vec<2, T>(0x1p20f * f.z_far); }).empty());
    const std::string opening = " must be above 0 and at most 2^20, or 0 with a half_size; got 2.09715e+06";
    CHECK(with([](auto& f) { f.tan_half_x = 0x1p21f; }) == name + "tan_half_x" + opening);
    CHECK(with([](auto& f) { f.tan_half_y = 0x1p21f; }) == name + "tan_half_y" + opening);
    CHECK(with([](auto& f) { f.shift.y = -0x1p21f; }) ==
          name + "shift must be from -2^20 to 2^20; got (0, -2.09715e+06)");
    CHECK(with([](auto& f) { f.half_size.y = 0x1p21f * f.z_far; }) ==
          name + "half_size must be at most 2^20 z_far; got (0, 2.09715e+08)");
    for (T bad : {T(-1), nan}) CHECK(with([&](auto& f) { f.z_near = bad; }).starts_with(name + "z_near "));
    for (T bad : {T(0.1), T(0), nan, infinity})
        CHECK(with([&](auto& f) { f.z_far = bad; }).starts_with(name + "z_far "));
    CHECK(with([](auto& f) { f.direction = {}; }).starts_with(name + "direction "));
    CHECK(with([&](auto& f) { f.direction.x = nan; }).starts_with(name + "direction "));
    CHECK(with([&](auto& f) { f.position.y = infinity; }).starts_with(name + "position "));
}
