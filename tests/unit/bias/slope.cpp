// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

namespace {

/// A spot and a directional light for every clip space.
template <class T>
std::vector<light_space<T>> lights() {
    using vec = glm::vec<3, T>;
    std::vector<light_space<T>> all;
    for (const clip_space clip : all_clip_spaces()) {
        all.push_back(make_spot_light<T>(
            {.position = vec(1, 5, 2), .direction = vec(T(-0.2), -1, T(0.3)), .z_near = 1, .z_far = 20, .clip = clip}));
        all.push_back(fit_directional_light<T>(
            {.direction = vec(1, -2, T(0.5)), .receivers = bounding_box<T>{vec(-3), vec(3)}, .clip = clip}));
    }
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE("plane_in_map: across every direction of the projected plane", T, float, double) {
    for (const light_space<T>& light : lights<T>()) {
        const glm::mat<4, 4, T> to_texels = texture_matrix(light, {512, 256});
        const glm::dvec3 p(0.3, 0.2, 0.1), normal(0.2, 1, -0.1), u(1, -0.2, 0),
            v(0, 0.1, 1);  // u and v lie in the plane
        const glm::dvec3 got(plane_in_map(plane_matrix(to_texels), glm::vec<3, T>(normal), glm::vec<3, T>(p)));
        for (const glm::dvec3& along : {u, v}) {
            const glm::dvec3 way = through(to_texels, p + 0.1 * along) - through(to_texels, p);
            CHECK(glm::abs(glm::dot(got, way)) < (sizeof(T) == 4 ? 1e-4 : 1e-11) * glm::length(got) * glm::length(way));
        }
    }
}

TEST_CASE_TEMPLATE("receiver_slope: of a plane, not clamped; none without a normal", T, float, double) {
    using vec = glm::vec<3, T>;
    for (const light_space<T>& light : lights<T>()) {
        const auto planes = plane_matrix(texture_matrix(light, {512, 256}));
        const vec normal(T(0.2), 1, T(-0.1)), world(T(0.3), 0, T(0.1));
        CHECK(receiver_slope(planes, normal, world) == plane_slope(planes, normal, world));
        CHECK(receiver_slope(planes, vec(0), world) == glm::vec<2, T>(0));
    }
    const glm::mat<4, 4, T> identity(T(1));
    CHECK(receiver_slope(identity, vec(T(-3), T(5), 1), vec(7, 8, 9)) == glm::vec<2, T>(T(3), T(-5)));
    CHECK(receiver_slope(identity, vec(1, 0, 0), vec(0)).x < T(-1e24));  // edge-on
    CHECK(receiver_slope(identity, vec(1, 0, 0), vec(0)).y == 0);
}

TEST_CASE_TEMPLATE("cascade_slope: plane_slope of a map that is a rotation, a scale and an offset", T, float, double) {
    const glm::vec<4, T> scale(T(3), T(-5), T(0.25), T(0)), offset(T(7), T(1), T(0.5), T(0));
    glm::mat<4, 4, T> to_texels(1);
    for (glm::length_t i = 0; i < 3; ++i) to_texels[i][i] = scale[i], to_texels[3][i] = offset[i];
    const glm::vec<3, T> normal(T(0.2), T(-0.4), T(1.5));
    const auto got = cascade_slope(normal, scale);
    const auto expected = plane_slope(plane_matrix(to_texels), normal, glm::vec<3, T>(T(0.3), T(2), T(1)));
    CHECK(glm::length(got - expected) < T(1e-6));
    CHECK(cascade_slope(glm::vec<3, T>(0), scale) == glm::vec<2, T>(0));
    CHECK(std::abs(cascade_slope(glm::vec<3, T>(1, 1, 0), scale).x) > T(1e12));  // edge-on
}

TEST_CASE_TEMPLATE("plane_slope: the plane through three projected points", T, float, double) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-1, 1), tilt(-1, 1);
    double worst = 0;
    for (const light_space<T>& light : lights<T>()) {
        const glm::mat<4, 4, T> to_texels = texture_matrix(light, {512, 256});
        const glm::mat<4, 4, T> planes = plane_matrix(to_texels);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec3 normal(tilt(random), 1.5, tilt(random));  // seen by every light at less than 80 degrees
            const glm::dvec3 u = 0.1 * glm::normalize(glm::cross(normal, glm::dvec3(1, 0, 0.3)));
            const glm::dvec3 v = 0.1 * glm::normalize(glm::cross(normal, u));
            const glm::dvec3 a = through(to_texels, p), b = through(to_texels, p + u), c = through(to_texels, p + v);
            const glm::dvec3 across = glm::cross(b - a, c - a);
            const glm::dvec2 expected(-across.x / across.z, -across.y / across.z);
            const auto got = plane_slope(planes, glm::vec<3, T>(normal), glm::vec<3, T>(p));
            worst = worse(worst, glm::length(glm::dvec2(got) - expected) / glm::length(expected));
        }
    }
    CHECK(worst < (sizeof(T) == 4 ? 1e-3 : 1e-9));
}

TEST_CASE_TEMPLATE("plane_slope, clamp_slope: edge-on, zero normal, NaN", T, float, double) {
    using vec = glm::vec<3, T>;
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const glm::mat<4, 4, T> identity(T(1));
    using slope = glm::vec<2, T>;
    CHECK(plane_slope(identity, vec(T(0.25), T(-0.5), 1), vec(7, 8, 9)) == slope(T(-0.25), T(0.5)));
    CHECK(plane_slope(identity, vec(T(0.5), -1, 2), vec(7, 8, 9)) == slope(T(-0.25), T(0.5)));  // of any length
    CHECK(glm::abs(plane_slope(identity, vec(1, -1, 0), vec(0))) == slope(2));                  // edge-on
    for (vec bad : {vec(0), vec(nan), vec(inf), vec(0, nan, 1)}) {
        const slope got = plane_slope(identity, bad, vec(1));
        for (int i = 0; i < 2; ++i) CHECK((got[i] >= -2 && got[i] <= 2));
        CHECK(acne_free_bias(got, T(0.5), T(0)) == 1);
    }
    for (T v : {T(2), T(3), inf, nan, -nan}) CHECK(clamp_slope(v) == 2);
    for (T v : {T(-2), T(-3), -inf}) CHECK(clamp_slope(v) == -2);
    CHECK(clamp_slope(T(-1.5)) == T(-1.5));
}

TEST_CASE("plane_matrix: what has no inverse") {
    CHECK(complaint([] { static_cast<void>(plane_matrix(glm::mat4(0))); }) ==
          "umbrage::plane_matrix: texture_matrix must be finite, with a finite inverse; got "
          "((0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0), (0, 0, 0, 0))");
    glm::mat4 bad(1);
    bad[2][1] = std::numeric_limits<float>::quiet_NaN();
    CHECK(!complaint([&] { static_cast<void>(plane_matrix(bad)); }).empty());
    bad[2][1] = std::numeric_limits<float>::infinity();
    CHECK(!complaint([&] { static_cast<void>(plane_matrix(bad)); }).empty());
}

TEST_CASE_TEMPLATE("slope_bias: by hand, and at least acne_free_bias with twice the reach", T, float, double) {
    using vec = glm::vec<2, T>;
    CHECK(slope_bias(vec(T(0.125), T(-0.25)), T(2), T(0.125)) == T(0.625));
    CHECK(slope_bias(vec(T(-0.25), T(0.125)), T(2), T(0.125)) == T(0.625));
    CHECK(slope_bias(vec(T(0.25)), T(-2), T(0.125)) == 0);
    CHECK(slope_bias(vec(1), T(1), T(1)) == 1);
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (vec bad : {vec(nan, 0), vec(0, nan), vec(inf, 0), vec(0, -inf), vec(nan)})
        CHECK(slope_bias(bad, T(1), T(0)) == 1);
    std::mt19937 random(3);
    std::uniform_real_distribution<T> steep(T(-0.1), T(0.1)), texels(T(0.5), T(4));
    for (int i = 0; i < 10000; ++i) {
        const vec slope(steep(random), steep(random));
        const T reach = texels(random);
        CHECK(slope_bias(slope, T(2) * reach, T(0x1p-22)) >= acne_free_bias(slope, reach, T(0)));
    }
}
