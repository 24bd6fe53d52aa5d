// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../special_values.hpp"

using namespace umbrage;
using doctest::Approx;

namespace {

static_assert(linear_depth(5.0f, 0.125f) == 0.625f);
static_assert(linear_depth(-5.0, 0.125) == -0.625 && linear_depth(16.0, 0.125) == 2.0);  // not clamped
static_assert(project_depth(1.0f, 4.0f, 1.0f) == 0.25f && project_depth(1.0f, 4.0f, 0.0f) == 0.25f);
static_assert(reverse_depth(0.25f) == 0.75f && reverse_depth(1.0) == 0.0);
static_assert(depth_from_ndc(-1.0f) == 0.0f && depth_from_ndc(0.0f) == 0.5f && depth_from_ndc(1.0f) == 1.0f);
static_assert(view_z_from_depth(0.0f, 2.0f, 8.0f) == 2.0f && view_z_from_depth(1.0f, 2.0f, 8.0f) == 8.0f);
static_assert(view_z_from_depth(0.5f, 2.0f, 8.0f) == 3.2f);  // 2 / (1 - 3/8)
static_assert(depth_from_view_z(2.0f, 2.0f, 8.0f) == 0.0f && depth_from_view_z(8.0f, 2.0f, 8.0f) == 1.0f);
static_assert(depth_from_view_z(4.0, 2.0, 8.0) == 0.5 / 0.75);
static_assert(view_z_from_reversed_depth(1.0f, 2.0f, 8.0f) == 2.0f &&
              view_z_from_reversed_depth(0.0f, 2.0f, 8.0f) == 8.0f);
static_assert(view_z_from_reversed_depth(0.5f, 2.0f, 8.0f) == 3.2f);  // 2 / (1/4 + 3/8)
static_assert(reversed_depth_from_view_z(2.0f, 2.0f, 8.0f) == 1.0f &&
              reversed_depth_from_view_z(8.0f, 2.0f, 8.0f) == 0.0f);
static_assert(reversed_depth_from_view_z(4.0, 2.0, 8.0) == 0.25 / 0.75);
static_assert(view_z_from_orthographic_depth(0.25f, -2.0f, 6.0f) == 0.0f);
static_assert(view_z_from_orthographic_depth(0.25f, 6.0f, -2.0f) == 4.0f);  // reversed
static_assert(orthographic_depth_from_view_z(0.0f, -2.0f, 6.0f) == 0.25f);
static_assert(orthographic_depth_from_view_z(4.0f, 6.0f, -2.0f) == 0.25f);

}  // namespace

TEST_CASE("project_depth: far where the point is not in front of the light, whichever way depth runs") {
    for (auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const float far_depth = cleared_depth({.direction = direction});
        for (float w : {0.0f, -0.0f, -1.0f, -inf32, nan32, -nan32}) {
            CHECK(project_depth(0.25f, w, far_depth) == far_depth);
            CHECK(project_depth(0.25, double(w), double(far_depth)) == far_depth);
        }
        CHECK(project_depth(3.0f, inf32, far_depth) == 0.0f);
        CHECK(is_nan(project_depth(nan32, 1.0f, far_depth)));
        CHECK(project_depth(-1.0f, 2.0f, far_depth) == -0.5f);  // not clamped
    }
}

TEST_CASE("distance_depth: Pythagoras over the range") {
    CHECK(distance_depth(glm::vec3(3, 0, 4), 0.125f) == 0.625f);
    CHECK(distance_depth(glm::vec3(2, -3, 6), 0.25f) == 1.75f);
    CHECK(distance_depth(glm::vec3(0), 1.0f) == 0.0f);
    const glm::dvec3 p(0.1, -0.7, 12.5);
    CHECK(double(distance_depth(glm::vec3(p), 0.05f)) == Approx(distance_depth(p, 0.05)).epsilon(3e-7));
}

TEST_CASE("reverse_depth: its own inverse on the lattice of 24 bits, exact from 1/2 to 2") {
    int wrong = 0;
    for (int k = 0; k <= 1 << 24; k += 7) {
        const float d = float(k) / 16777216.0f;
        wrong += reverse_depth(reverse_depth(d)) != d || double(reverse_depth(d)) != 1.0 - double(d);
    }
    CHECK(wrong == 0);
    for (float d : {0.5f, 0x1.000002p-1f, 0.7f, 0x1.fffffep-1f, 1.0f, 1.3f, 0x1.fffffep0f, 2.0f})
        CHECK(double(reverse_depth(d)) == 1.0 - double(d));
    CHECK(reverse_depth(1e-10f) == 1.0f);
}

TEST_CASE("depth_from_ndc: ends, middle and out of range") {
    CHECK(depth_from_ndc(-3.0f) == -1.0f);
    CHECK(depth_from_ndc(0.5) == 0.75);
    CHECK(depth_from_ndc(inf32) == inf32);
}

TEST_CASE("view_z_from_depth, depth_from_view_z: inverse to each other, in order, also without a far plane") {
    for (double z_far : {10.0, 1000.0, std::numeric_limits<double>::infinity()}) {
        double previous = -1;
        for (double z = 0.5; z <= 10; z += 0.25) {
            const double d = depth_from_view_z(z, 0.5, z_far);
            CHECK(d > previous);
            CHECK(view_z_from_depth(d, 0.5, z_far) == Approx(z).epsilon(1e-12));
            CHECK(double(depth_from_view_z(float(z), 0.5f, float(z_far))) == Approx(d).epsilon(1e-6));
            previous = d;
        }
    }
    CHECK(view_z_from_depth(1.0f, 0.5f, inf32) == inf32);
    CHECK(depth_from_view_z(inf32, 0.5f, inf32) == 1.0f);
}

TEST_CASE("view_z_from_reversed_depth, reversed_depth_from_view_z: what the forward ones say of 1 - depth") {
    for (double z_far : {10.0, 1000.0, std::numeric_limits<double>::infinity()}) {
        double previous = 2;
        for (double z = 0.5; z <= 10; z += 0.25) {
            const double d = reversed_depth_from_view_z(z, 0.5, z_far);
            CHECK(d < previous);
            CHECK(d == Approx(1 - depth_from_view_z(z, 0.5, z_far)).epsilon(1e-12));
            CHECK(view_z_from_reversed_depth(d, 0.5, z_far) == Approx(z).epsilon(1e-12));
            previous = d;
        }
    }
    CHECK(view_z_from_reversed_depth(0.0f, 0.5f, inf32) == inf32);
    CHECK(view_z_from_reversed_depth(0.125f, 0.5f, inf32) == 4.0f);
    CHECK(reversed_depth_from_view_z(4.0f, 0.5f, inf32) == 0.125f);
}

TEST_CASE("view_z_from_reversed_depth: keeps the digits that 1 - depth drops") {
    for (float z_far : {100.0f, 1000.0f, 1e6f, inf32}) {
        CAPTURE(z_far);
        double direct = 0, by_way_of_forward = 0, round_trip = 0;
        for (int i = 0; i < 100000; ++i) {
            const float depth = std::exp2(float(i) * -20.0f / 100000);  // 1 down to 2^-20
            const double ratio = 0.1f / double(z_far), exact = 0.1f / (ratio + double(depth) * (1 - ratio));
            const float z = view_z_from_reversed_depth(depth, 0.1f, z_far);
            direct = std::max(direct, std::abs(z - exact) / exact);
            by_way_of_forward = std::max(
                by_way_of_forward, std::abs(view_z_from_depth(reverse_depth(depth), 0.1f, z_far) - exact) / exact);
            if (z < z_far)
                round_trip =
                    std::max(round_trip, std::abs(double(view_z_from_reversed_depth(
                                                      reversed_depth_from_view_z(z, 0.1f, z_far), 0.1f, z_far)) -
                                                  z) /
                                             z);
        }
        CHECK(direct < 0x3p-23);
        CHECK(round_trip < 0x6p-23);
        CHECK(by_way_of_forward > 100 * direct);
    }
}

TEST_CASE(
    "view_z_from_orthographic_depth, orthographic_depth_from_view_z: the directional light's matrices, either way") {
    for (auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const auto light =
            make_directional_light<double>({.direction = {0, 0, -1},
                                            .offset = 0,
                                            .z_near = -2,
                                            .z_far = 6,
                                            .clip = {.range = depth_range::zero_to_one, .direction = direction}});
        const glm::dmat4 m = texture_matrix(light, {1, 1});
        const bool reversed = direction == depth_direction::reversed;
        const double z_near = reversed ? 6 : -2, z_far = reversed ? -2 : 6;
        for (double z = -2; z <= 6; z += 0.125) {
            const double depth = project_coordinate(shadow_coordinate(m, glm::dvec3(0, 0, -z))).z;
            CHECK(orthographic_depth_from_view_z(z, z_near, z_far) == Approx(depth).epsilon(1e-12));
            CHECK(view_z_from_orthographic_depth(depth, z_near, z_far) == Approx(z).epsilon(1e-12));
            CHECK(view_z_from_orthographic_depth(float(depth), float(z_near), float(z_far)) == Approx(z).epsilon(1e-6));
        }
    }
}
