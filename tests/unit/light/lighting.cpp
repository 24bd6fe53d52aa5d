// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/light/lighting.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("spot_cone: by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec down(0, -1, 0);
    // 3-4-5: the point (3, -4) is at a cosine of 0.8
    CHECK(spot_cone(down, vec(3, -4, 0), T(0.79)) == 1);
    CHECK(spot_cone(down, vec(3, -4, 0), T(0.81)) == 0);
    CHECK(spot_cone(down, vec(0, -4, -3) * T(1000), T(0.79)) == 1);
    CHECK(spot_cone(down, vec(0, -4, 3) * T(0.001), T(0.81)) == 0);
    CHECK(spot_cone(down, vec(0, -1, 0), T(0.999)) == 1);
    CHECK(spot_cone(down, vec(0, 1, 0), T(0.5)) == 0);  // behind: its square would pass
    CHECK(spot_cone(down, vec(3, 4, 0), T(0.1)) == 0);
    CHECK(spot_cone(down, vec(1, 0, 0), T(0)) == 0);  // 90 degrees: the edge is outside
    CHECK(spot_cone(down, vec(1, T(-0.01), 0), T(0)) == 1);
    CHECK(spot_cone(down, vec(0, 0, 0), T(0)) == 0);  // the apex
    CHECK(spot_cone(down, vec(0, 0, 0), T(0.5)) == 0);
}

TEST_CASE("spot_cone: as the normalized test in double, but for 2^-22 around the edge") {
    std::mt19937 random(1);
    std::normal_distribution<float> coordinate;
    std::uniform_real_distribution<float> edge(0, 0.9999f), power(-30, 30);
    int wrong = 0, inside = 0, near_edge = 0;
    constexpr int count = 200000;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 axis = glm::normalize(glm::vec3(coordinate(random), coordinate(random), coordinate(random)));
        const glm::vec3 to_point =
            glm::vec3(coordinate(random), coordinate(random), coordinate(random)) * std::exp2(power(random));
        const double cosine = glm::dot(glm::dvec3(axis), glm::normalize(glm::dvec3(to_point)));
        // every other cone has its edge close to the point
        float cos_outer = edge(random);
        if (i % 2 && cosine > 0.01)
            cos_outer = std::min(0.9999f, static_cast<float>(cosine * (1 + (edge(random) - 0.5) * 1e-5)));
        const float got = spot_cone(axis, to_point, cos_outer);
        if (std::abs(cosine - double(cos_outer)) < 0x1p-22) {
            ++near_edge;
            continue;
        }
        wrong += got != (cosine > double(cos_outer) ? 1.0f : 0.0f);
        inside += got == 1.0f;
    }
    CHECK(wrong == 0);
    CHECK(inside > count / 10);
    CHECK(near_edge < count / 10);
}

TEST_CASE_TEMPLATE("spot_cone: NaN and overflow are outside", T, float, double) {
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    for (int i = 0; i < 3; ++i)
        for (T bad : {nan, -nan, infinity}) {
            glm::vec<3, T> direction(0, -1, 0), to_point(0.5, -1, 0.25);
            to_point[i] = bad;
            CHECK(spot_cone(direction, to_point, T(0.5)) == 0);
            if (is_nan(bad)) {
                direction[i] = bad;
                CHECK(spot_cone(direction, glm::vec<3, T>(0, -1, 0), T(0.5)) == 0);
            }
        }
    CHECK(spot_cone(glm::vec<3, T>(0, -1, 0), glm::vec<3, T>(0, -1, 0), nan) == 0);
    CHECK(spot_cone(glm::vec<3, T>(0, -1, 0), glm::vec<3, T>(0, -std::numeric_limits<T>::max(), 0), T(0.5)) == 0);
}

TEST_CASE_TEMPLATE("diffuse_ambient: by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec albedo(1, 0.5, 0.25);
    CHECK(diffuse_ambient(albedo, vec(T(0.25)), T(1), T(1)) == albedo);             // faced and lit: all of it
    CHECK(diffuse_ambient(albedo, vec(T(0.25)), T(1), T(0)) == albedo * T(0.25));   // shadow: ambient alone
    CHECK(diffuse_ambient(albedo, vec(T(0.25)), T(-1), T(1)) == albedo * T(0.25));  // turned away
    CHECK(diffuse_ambient(albedo, vec(T(0.25)), T(0.5), T(0.5)) == albedo * T(0.4375));
    CHECK(diffuse_ambient(albedo, vec(T(0)), T(-0.0), T(1)) == vec(0));
    CHECK(diffuse_ambient(albedo, vec(T(1)), T(0.3), T(0.7)) == albedo);
    const vec dusk(0.25, 0.5, 0);  // a colored sky
    CHECK(diffuse_ambient(albedo, dusk, T(1), T(0)) == albedo * dusk);
    CHECK(diffuse_ambient(albedo, dusk, T(0.5), T(0.5)) == albedo * vec(0.4375, 0.625, 0.25));
    const T nan = std::numeric_limits<T>::quiet_NaN();
    for (T away : {nan, -nan, std::numeric_limits<T>::signaling_NaN(), T(0)})  // whatever the light's visibility
        for (T visibility : {T(1), nan, std::numeric_limits<T>::infinity()})
            CHECK(diffuse_ambient(albedo, vec(T(0.25)), away, visibility) == albedo * T(0.25));
}

TEST_CASE("diffuse_ambient: float near double, between ambient and full light, brighter with visibility") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> share(0, 1), cosine(-1, 1);
    double worst = 0;
    int out_of_bounds = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 albedo(share(random), share(random), share(random));
        const glm::vec3 ambient(share(random), share(random), share(random));
        const float n_dot_l = cosine(random), visibility = share(random);
        const glm::vec3 got = diffuse_ambient(albedo, ambient, n_dot_l, visibility);
        const glm::dvec3 light =
            glm::dvec3(ambient) + (1.0 - glm::dvec3(ambient)) * double(visibility) * std::max(0.0, double(n_dot_l));
        worst = std::max(worst, glm::length(glm::dvec3(got) - glm::dvec3(albedo) * light));
        const glm::vec3 dark = diffuse_ambient(albedo, ambient, n_dot_l, 0.0f),
                        lit = diffuse_ambient(albedo, ambient, n_dot_l, 1.0f);
        for (int k = 0; k < 3; ++k) out_of_bounds += !(dark[k] <= got[k] && got[k] <= lit[k]);
    }
    CHECK(worst < 3e-7);
    CHECK(out_of_bounds == 0);
}
