// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/cube_map.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/filter/pcf/hard.hpp>

using namespace umbrage;

namespace {

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return {normal(random), normal(random), normal(random)};
}

}  // namespace

TEST_CASE("cube_coordinate: a view along the face with 90 degrees sees a direction there") {
    std::mt19937 random(1);
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 direction = random_direction(random);
        const glm::dvec3 at = cube_coordinate(direction);
        const cube_axes axes = cube_faces[static_cast<std::size_t>(at.z)];
        const glm::dvec3 forward(axes.forward), up(axes.up), right = glm::cross(forward, up);
        const double w = glm::dot(direction, forward);
        CHECK(w > 0);
        CHECK(std::abs(glm::dot(direction, right) / w - (2 * at.x - 1)) < 1e-12);
        CHECK(std::abs(glm::dot(direction, up) / w - (2 * at.y - 1)) < 1e-12);
        CHECK(at.x >= 0);
        CHECK(at.x <= 1);
        CHECK(at.y >= 0);
        CHECK(at.y <= 1);
    }
}

TEST_CASE("cube_faces: what light_space's cameras make of them is the same") {
    std::mt19937 random(2);
    for (std::size_t face = 0; face < 6; ++face) {
        const auto view = look_along(glm::dvec3(0), glm::dvec3(cube_faces[face].forward),
                                     glm::dvec3(cube_faces[face].up), handedness::right);
        const auto projection = perspective(1.0, 1.0, 0.1, 10.0, clip_space{});
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 direction = random_direction(random);
            const glm::dvec3 at = cube_coordinate(direction);
            if (static_cast<std::size_t>(at.z) != face) continue;
            const glm::dvec4 clip = projection * view * glm::dvec4(direction, 1);
            CHECK(std::abs(clip.x / clip.w - (2 * at.x - 1)) < 1e-12);
            CHECK(std::abs(clip.y / clip.w - (2 * at.y - 1)) < 1e-12);
        }
    }
}

TEST_CASE("cube_direction: there and back") {
    for (int face = 0; face < 6; ++face)
        for (int t = 0; t < 64; ++t)
            for (int s = 0; s < 64; ++s) {
                const glm::vec2 st((static_cast<float>(s) + 0.5f) / 64.0f, (static_cast<float>(t) + 0.5f) / 64.0f);
                const glm::vec3 direction = cube_direction(static_cast<float>(face), st);
                CHECK(cube_coordinate(direction) == glm::vec3(st, static_cast<float>(face)));
                CHECK(glm::vec2(cube_coordinate(direction * 3.0f)) == st);
            }
}

TEST_CASE("cube_face: edges and corners go to x, then y; zero, infinity and NaN have an answer") {
    CHECK(cube_face(glm::vec3(1, 1, 1)) == 0);
    CHECK(cube_face(glm::vec3(-1, 1, -1)) == 1);
    CHECK(cube_face(glm::vec3(0, 1, 1)) == 2);
    CHECK(cube_face(glm::vec3(0, -1, 1)) == 3);
    CHECK(cube_face(glm::vec3(0)) == 0);
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    CHECK(cube_face(glm::vec3(0, 0, -infinity)) == 5);
    const image<float> map({4, 4}, 0.0f);
    for (const glm::vec3 bad : {glm::vec3(0), glm::vec3(nan), glm::vec3(1, nan, 0), glm::vec3(nan, 0, 1),
                                glm::vec3(infinity), glm::vec3(0, 1, nan)}) {
        CAPTURE(bad.x);
        const glm::vec3 at = cube_coordinate(bad);
        CHECK(at.z >= 0.0f);
        CHECK(at.z <= 5.0f);
        CHECK(hard(clamped(map), glm::vec2(at) * 4.0f, 0.5f) == 1.0f);
    }
}

TEST_CASE("cube_tile: six tiles that do not meet") {
    for (int a = 0; a < 6; ++a) {
        const glm::ivec2 first = cube_tile(a, 16);
        CHECK(first.x >= 0);
        CHECK(first.x <= 32);
        CHECK((first.y == 0 || first.y == 16));
        for (int b = 0; b < a; ++b) CHECK(cube_tile(b, 16) != first);
    }
}
