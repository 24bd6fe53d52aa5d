// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <umbrage/filter/pcf/disc_tap.hpp>

#include "../../special_values.hpp"
#include "../maps.hpp"

using namespace umbrage;

TEST_CASE("disc_rotation: 16 turns in each 4 x 4 pixels, no two alike, of nearly one length and spacing") {
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(-8, 4), glm::ivec2(1916, 1077), glm::ivec2(3, -2)}) {
        std::set<std::pair<float, float>> turns;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x) {
                const glm::vec4 rotation = disc_rotation(glm::vec2(corner + glm::ivec2(x, y)));
                CHECK(rotation == disc_rotation(glm::vec2(corner + glm::ivec2(x, y)) + 0.5f));
                const double length = std::hypot(double(rotation.x), double(rotation.z));
                CHECK(length <= 64.0);
                CHECK(length >= 63.6);
                const double sixteenths = std::atan2(double(rotation.z), double(rotation.x)) / (std::numbers::pi / 8);
                CHECK(std::abs(sixteenths - std::round(sixteenths)) < 0.02);
                CHECK(rotation == glm::vec4(rotation.x, -rotation.z, rotation.z, rotation.x));
                turns.insert({rotation.x, rotation.z});
            }
        CHECK(turns.size() == 16);
    }
    for (const glm::vec2 far : coordinates_outside_texel_space())
        CHECK(disc_rotation(far) == glm::vec4(64.0f, 0.0f, 0.0f, 64.0f));
}

TEST_CASE("disc_radius: sixteenths of a texel, rounded down, and what is out of range") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    CHECK(disc_radius(3.0f) == 48.0f);
    CHECK(disc_radius(std::nextafter(3.0f, 0.0f)) == 47.0f);
    CHECK(disc_radius(0.0624f) == 0.0f);
    CHECK(disc_radius(-1.0f) == 0.0f);
    CHECK(disc_radius(nan) == 0.0f);
    CHECK(disc_radius(max_disc_radius) == 4095.0f);
    CHECK(disc_radius(std::nextafter(max_disc_radius, 0.0f)) == 4094.0f);
    CHECK(disc_radius(infinity) == 4095.0f);
    static_assert(disc_radius(1e30) == 4095.0);
}

TEST_CASE("sheared_rotation: x moves with y, and a square under it becomes a parallelogram") {
    const glm::vec4 rotation = disc_rotation(glm::vec2(1, 2));
    CHECK(sheared_rotation(rotation, 0.0f) == rotation);
    const glm::vec4 sheared = sheared_rotation(rotation, 0.5f);
    const glm::vec2 radius(160, 48), position(glm::floor(glm::vec2(100.3f, 80.9f) * 256.0f));
    int moved = 0;
    for (const glm::ivec2 point : disc_points<32>) {
        const glm::dvec2 p(point);
        const glm::dvec4 r(rotation);
        const double x = r.x * p.x + r.y * p.y, y = r.z * p.x + r.w * p.y;
        const glm::dvec2 at = glm::dvec2(position) / 256.0 + glm::dvec2((x + 0.5 * y) * 160, y * 48) / 16384.0;
        CHECK(disc_tap(position, glm::vec2(point), sheared, radius) == glm::vec2(glm::floor(at)));
        moved += disc_tap(position, glm::vec2(point), sheared, radius) !=
                 disc_tap(position, glm::vec2(point), rotation, radius);
    }
    CHECK(moved > 16);
}
