// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <umbrage/light/bounds.hpp>
#include <umbrage/light/frustum.hpp>

#include "cameras.hpp"
#include "clip_spaces.hpp"

using namespace umbrage;

namespace {

bool within(const polyhedron& body, glm::dvec3 p, double beyond) {
    return std::ranges::all_of(body.faces(), [&](const polyhedron::face& f) {
        return glm::dot(f.plane, glm::dvec4(p, 1)) >= -beyond * glm::length(glm::dvec3(f.plane));
    });
}

}  // namespace

TEST_CASE("make_frustum: a frustum from its own matrices, with and without a far plane, in every convention") {
    std::mt19937 random(1);
    for (clip_space clip : all_clip_spaces())
        for (int i = 0; i < 20; ++i) {
            CAPTURE(to_string(clip));
            const auto f = bodies::random_frustum(random);
            const glm::dmat4 view = look_along(f.position, f.direction, f.up, clip.hand);
            const double z_far = i % 2 ? f.z_far : std::numeric_limits<double>::infinity();
            const auto made =
                make_frustum<double>({.view = view,
                                      .projection = perspective(f.tan_half_x, f.tan_half_y, f.z_near, z_far, clip),
                                      .z_near = f.z_near,
                                      .z_far = f.z_far,
                                      .clip = clip});
            CHECK(made.shift == glm::dvec2(0));
            CHECK(made.half_size == glm::dvec2(0));
            const auto expected = corners(f), got = corners(made);
            for (std::size_t k = 0; k < 8; ++k) CHECK(glm::length(expected[k] - got[k]) < 1e-12);
        }
}

TEST_CASE("make_frustum: holds what each eye sees; of one eye that looks along the view nothing else") {
    std::mt19937 random(2);
    for (clip_space clip : all_clip_spaces())
        for (const auto kind : cameras::all_kinds) {
            CAPTURE(to_string(clip));
            CAPTURE(to_string(kind));
            const auto camera = cameras::of_kind(kind, cameras::random_view(random, 100, clip), clip);
            const polyhedron body = make_frustum(camera);
            const bool two = camera.other_eye.has_value();
            int beside = 0;
            for (int i = 0; i < 200; ++i) {
                const double z = bodies::real(0.5, 60)(random);
                const glm::dmat4& eye = two && i % 2 ? *camera.other_eye : camera.projection;
                CHECK(within(body, cameras::seen_by(camera, eye, z, random), 1e-9));
                const double past = clip.hand == handedness::right ? -z : z;
                const glm::dvec4 aside(bodies::random_vector(random, -1, 1) * (30 + z), 1);
                const glm::dvec3 p = glm::inverse(camera.view) * glm::dvec4(aside.x, aside.y, past, 1);
                const glm::dvec4 h = camera.projection * camera.view * glm::dvec4(p, 1);
                const bool seen = std::abs(h.x) <= h.w && std::abs(h.y) <= h.w;
                if (!two) CHECK(within(body, p, 0) == seen);
                beside += !within(body, p, 0);
            }
            CHECK(beside > 20);
        }
}

TEST_CASE("make_frustum: two eyes with parallel views fill their frustum; two turned ones most of it") {
    const glm::dmat4 view(1);
    const auto f = make_frustum(cameras::of_kind(cameras::kind::two_eyes, view, opengl_clip_space));
    CHECK(f.tan_half_x == doctest::Approx(0.9));
    CHECK(f.half_size.x == doctest::Approx(0.032));
    CHECK(f.half_size.y == 0);
    const auto turned = make_frustum(cameras::of_kind(cameras::kind::turned_eyes, view, opengl_clip_space));
    CHECK(turned.tan_half_x == doctest::Approx(std::tan(std::atan(0.9) + 0.17)));
    CHECK(turned.tan_half_y < 0.55 * 1.2);
}

TEST_CASE("make_frustum: sides keep their bits while the view moves, in float too") {
    std::mt19937 random(3);
    for (const auto kind : cameras::all_kinds) {
        const auto of_view = [&](const glm::dmat4& view) {
            const auto c = cameras::of_kind(kind, view, unity_clip_space);
            camera_matrices<float> single{glm::mat4(c.view), glm::mat4(c.projection), {}, 0.5f, 60, c.clip};
            if (c.other_eye) single.other_eye = glm::mat4(*c.other_eye);
            return make_frustum(single);
        };
        const double radius = sphere_around(of_view(glm::dmat4(1))).radius;
        for (int i = 0; i < 50; ++i)
            CHECK(sphere_around(of_view(cameras::random_view(random, 100, unity_clip_space))).radius == radius);
    }
}

TEST_CASE("sphere_around: of any camera, holds its corners, none smaller about its middle line") {
    std::mt19937 random(4);
    for (const auto kind : cameras::all_kinds) {
        CAPTURE(to_string(kind));
        const auto f = make_frustum(
            cameras::of_kind(kind, cameras::random_view(random, 10, opengl_clip_space), opengl_clip_space));
        const auto sphere = sphere_around(f);
        const auto farthest = [&](glm::dvec3 from) {
            double r = 0;
            for (const glm::dvec3& c : corners(f)) r = std::max(r, glm::length(c - from));
            return r;
        };
        CHECK(farthest(sphere.center) == doctest::Approx(sphere.radius).epsilon(1e-12));
        const glm::dvec3 along = detail::axes(f, "") * glm::dvec3(f.shift, 1.0);
        for (double step : {-1e-4, 1e-4}) CHECK(farthest(sphere.center + along * step * sphere.radius) > sphere.radius);
    }
}

TEST_CASE_TEMPLATE("make_frustum: bad input", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const auto with = [](auto change) {
        camera_matrices<T> c{.projection = perspective(T(1), T(0.5), T(0.1), T(10), opengl_clip_space),
                             .clip = opengl_clip_space};
        change(c);
        return complaint([&] { (void)make_frustum(c); });
    };
    const std::string name = "umbrage::make_frustum: ";
    CHECK(with([](auto&) {}).empty());
    CHECK(with([](auto& c) { c.clip = {}; }).starts_with(name + "clip "));
    CHECK(with([](auto& c) { c.z_near = 0; }).empty());
    for (T bad : {T(-1), nan, T(200)}) CHECK(with([&](auto& c) { c.z_near = bad; }).starts_with(name + "z_"));
    CHECK(with([&](auto& c) { c.z_far = infinity; }).starts_with(name + "z_far "));
    CHECK(with([](auto& c) { c.view[0][0] = 2; }).starts_with(name + "view "));
    CHECK(with([&](auto& c) { c.view[3][0] = nan; }).starts_with(name + "view "));
    CHECK(with([&](auto& c) { c.projection[1][1] = nan; }).starts_with(name + "projection "));
    CHECK(with([](auto& c) { c.projection[1][1] = 0; }).starts_with(name + "projection "));
    CHECK(with([](auto& c) { c.clip.hand = handedness::left; }).starts_with(name + "projection "));
    CHECK(with([](auto& c) { c.other_eye = glm::mat<4, 4, T>(0); }).starts_with(name + "other_eye "));
    CHECK(with([](auto& c) { c.projection = glm::mat<4, 4, T>(1); }).empty());  // orthographic

    frustum<T> f{.tan_half_x = 0, .half_size = {T(1), T(0)}};
    CHECK(complaint([&] { (void)corners(f); }).empty());
    f.shift.x = infinity;
    CHECK(complaint([&] { (void)corners(f); }).starts_with("umbrage::corners: frustum.shift "));
    for (T bad : {T(-1), nan, infinity}) {
        f = {.half_size = {T(0), bad}};
        CHECK(complaint([&] { (void)corners(f); }).starts_with("umbrage::corners: frustum.half_size "));
    }
}
