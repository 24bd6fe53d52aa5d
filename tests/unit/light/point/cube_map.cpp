// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/cube_map.hpp>

#include <algorithm>
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
        const auto projection = perspective(1.0, 1.0, 0.1, 10.0, cpu_clip_space);
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

TEST_CASE("cube_view_z, cube_plane, cube_point: a direction's parts and back, with its bits") {
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 direction(random_direction(random));
        const glm::vec3 p = cube_plane(direction);
        const float m = cube_view_z(direction);
        CHECK(m == std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}));
        CHECK(cube_point(p.z, glm::vec3(glm::vec2(p), m)) == direction);
        CHECK(cube_face_point(p.z, direction) == glm::vec3(glm::vec2(p), m));
    }
}

namespace {

/// Continuation of a face's row or column beyond its edge: the next face, its side, and the direction along it.
enum class edge { s_first, s_last, t_first, t_last };
struct beyond {
    int face;
    edge side;
    bool backwards;
};
/// Beyond s < 0, s > 1, t < 0 and t > 1; from the faces' axes in OpenGL 4.6, table 8.19.
constexpr beyond seams[6][4]{
    {{4, edge::s_last, false}, {5, edge::s_first, false}, {2, edge::s_last, true}, {3, edge::s_last, false}},
    {{5, edge::s_last, false}, {4, edge::s_first, false}, {2, edge::s_first, false}, {3, edge::s_first, true}},
    {{1, edge::t_first, false}, {0, edge::t_first, true}, {5, edge::t_first, true}, {4, edge::t_first, false}},
    {{1, edge::t_last, true}, {0, edge::t_last, false}, {4, edge::t_last, false}, {5, edge::t_last, true}},
    {{1, edge::s_last, false}, {0, edge::s_first, false}, {2, edge::t_last, false}, {3, edge::t_first, false}},
    {{0, edge::s_last, false}, {1, edge::s_first, false}, {2, edge::t_first, true}, {3, edge::t_last, true}}};

}  // namespace

TEST_CASE_TEMPLATE("cube_neighbor: the table of all seams, texels inside, none beyond corners", T, float, double) {
    for (const int size : {1, 2, 3, 8, 1024, 16384})
        for (int face = 0; face < 6; ++face) {
            const T n = T(size), last = n - T(1);
            const auto of = [&](T s, T t) { return cube_neighbor(glm::vec<3, T>(s, t, T(face)), n); };
            for (const T s : {T(-1), n})
                for (const T t : {T(-1), n}) CHECK(of(s, t).z == T(-1));
            for (int k = 0; k < size; k = k < 8 ? k + 1 : k * 2 + 3) {
                const T i = T(k), j = last - i;
                const glm::vec<3, T> outside[4]{of(T(-1), i), of(n, i), of(i, T(-1)), of(i, n)};
                for (std::size_t side = 0; side < 4; ++side) {
                    const beyond& to = seams[face][side];
                    const T along = to.backwards ? j : i;
                    const glm::vec<2, T> expected = to.side == edge::s_first   ? glm::vec<2, T>(T(0), along)
                                                    : to.side == edge::s_last  ? glm::vec<2, T>(last, along)
                                                    : to.side == edge::t_first ? glm::vec<2, T>(along, T(0))
                                                                               : glm::vec<2, T>(along, last);
                    CHECK(outside[side] == glm::vec<3, T>(expected, T(to.face)));
                }
                CHECK(of(i, j) == glm::vec<3, T>(i, j, T(face)));
            }
        }
}
