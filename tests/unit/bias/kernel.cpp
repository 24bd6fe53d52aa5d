// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("kernel_bias: by hand", T, float, double) {
    using vec = glm::vec<3, T>;
    const vec down(0, 0, -1);
    const auto of = [&](vec normal, T width, T greatest) { return kernel_bias(normal, down, down, width, greatest); };
    CHECK(of(vec(0, 0, 1), T(0.5), T(8)) == 0);
    CHECK(of(vec(4, 0, 3), T(3), T(8)) == doctest::Approx(4));  // 3-4-5, a normal of length 5
    CHECK(of(vec(0, T(-0.6), T(0.8)), T(4), T(8)) == doctest::Approx(3));
    CHECK(of(vec(4, 0, 3), T(3), T(1)) == 3);  // no more than 45 degrees
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    for (vec grazing : {vec(1, 0, 0), vec(0, 0, -1), vec(0, T(0.6), T(-0.8)), vec(0), vec(nan), vec(inf, 0, 0)})
        CHECK(of(grazing, T(3), T(8)) == 24);
    CHECK(of(vec(4, 0, 3), T(3), inf) == doctest::Approx(4));
    for (T bad : {nan, -nan, inf, T(-1)}) CHECK(of(vec(4, 0, 3), bad, T(8)) == 0);
    for (T bad : {nan, -nan, inf}) CHECK(of(vec(1, 0, 0), T(3), bad) == 0);
}

TEST_CASE("kernel_bias: in depth, it covers what acne_free_bias asks for, by no more than sqrt(2)") {
    std::mt19937 random(4);
    std::normal_distribution<double> coordinate;
    const glm::dvec3 position(1, 5, 2);
    const glm::dvec3 slanted = glm::normalize(glm::dvec3(1, -2, 0.5)),
                     along = glm::normalize(glm::dvec3(-0.2, -1, 0.3));
    for (const bool spot : {false, true}) {
        const glm::dvec3 direction = spot ? along : slanted;
        const light_space<double> light =
            spot ? make_spot_light<double>(
                       {.position = position, .direction = along, .z_near = 1, .clip = cpu_clip_space})
                 : make_directional_light<double>({.direction = slanted,
                                                   .map_size = glm::ivec2(1 << 16),
                                                   .texels_per_unit = 8192,
                                                   .clip = cpu_clip_space});
        const glm::ivec2 size(1 << 16);  // so that no slope meets its limit
        const glm::dmat4 to_texels = texture_matrix(light, size), planes = plane_matrix(to_texels);
        const glm::dvec2 units = make_light_units(light, size);
        double least = 2, greatest = 0;
        for (int i = 0; i < 20000; ++i) {
            const glm::dvec3 normal(coordinate(random), coordinate(random), coordinate(random));
            const glm::dvec3 point(coordinate(random), coordinate(random) * 0.3, coordinate(random));
            const double w = shadow_coordinate(to_texels, point).w;
            const glm::dvec3 way = spot ? (point - position) / w : direction;
            if (-glm::dot(glm::normalize(normal), way) < 0.06 || w < 1) continue;
            const double width = offset_width(1.5, texels_to_world(1.0, units, w));
            const double bias = world_to_depth(kernel_bias(normal, direction, way, width, 50.0), units, w);
            const double needed = acne_free_bias(plane_slope(planes, normal, point), 1.5, 0.0) - 0x1p-23;
            least = std::min(least, bias / needed);
            greatest = std::max(greatest, bias / needed);
        }
        CHECK(least > 0.9999);
        CHECK(least < 1.001);
        CHECK(greatest > 1.41);
        CHECK(greatest < 1.4143);
    }
}
