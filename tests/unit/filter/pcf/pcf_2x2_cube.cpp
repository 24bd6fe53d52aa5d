// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/pcf/pcf_2x2_cube.hpp>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <umbrage/filter/pcf/pcf_2x2.hpp>

using namespace umbrage;

namespace {

constexpr int face_size = 8;

image<double> random_atlas(std::mt19937& random) {
    image<double> atlas({3 * face_size, 2 * face_size});
    for (double& texel : atlas.texels()) texel = static_cast<double>(random() % 1024) / 1024.0;
    return atlas;
}

double on_face(const image<double>& atlas, int face, glm::dvec2 st, double receiver) {
    return pcf_2x2_cube(clamped(atlas), double(face_size), glm::dvec3(st, face), receiver);
}

/// A point of a face's edge, from the direction to it, on each face that meets there.
std::vector<glm::dvec3> on_all_faces(glm::dvec3 direction) {
    std::vector<glm::dvec3> all;
    for (int face = 0; face < 6; ++face) {
        const glm::dvec3 forward(cube_faces[static_cast<std::size_t>(face)].forward);
        const double m = glm::dot(forward, direction);
        if (m < 1) continue;
        const glm::dvec3 up(cube_faces[static_cast<std::size_t>(face)].up);
        all.push_back({(glm::dot(glm::cross(forward, up), direction) + 1) * face_size / 2,
                       (glm::dot(up, direction) + 1) * face_size / 2, face});
    }
    return all;
}

}  // namespace

TEST_CASE("pcf_2x2_cube: nothing jumps over any edge, nor at a corner") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    int partly = 0;
    for (int i = 0; i < 20000; ++i) {
        const image<double> atlas = random_atlas(random);
        const bool corner = i % 16 == 0;
        glm::dvec3 direction;
        for (glm::length_t axis = 0; axis < 3; ++axis) direction[axis] = random() % 2 ? 1 : -1;
        // now and then within a texel of a corner
        if (!corner)
            direction[i % 3] =
                i % 5 ? unit(random) : std::copysign(1 - std::abs(unit(random)) / face_size, unit(random));
        const auto faces = on_all_faces(direction);
        CHECK(faces.size() == (corner ? 3 : 2));
        const double receiver = 0.25 + 0.5 * std::abs(unit(random));
        const double first = on_face(atlas, int(faces[0].z), glm::dvec2(faces[0]), receiver);
        for (const glm::dvec3& f : faces) CHECK(on_face(atlas, int(f.z), glm::dvec2(f), receiver) == first);
        partly += first > 0 && first < 1;
    }
    CHECK(partly > 10000);
}

TEST_CASE_TEMPLATE("pcf_2x2_cube: inside a face it is pcf_2x2, on the grid of its weights", T, float, double) {
    std::mt19937 random(2);
    const image<double> drawn = random_atlas(random);
    image<T> atlas(drawn.size());
    for (int y = 0; y < 2 * face_size; ++y)
        for (int x = 0; x < 3 * face_size; ++x) atlas[{x, y}] = T(drawn[{x, y}]);
    for (int face = 0; face < 6; ++face)
        for (int i = 0; i < 500; ++i) {
            const auto inside = [&] { return T(0.5) + T(random() % (256 * (face_size - 1))) / T(256); };
            const T s = inside(), t = inside(), receiver = T(random() % 512) / T(512);
            const image_view<const T> tile =
                std::as_const(atlas).view().region(cube_tile(face, face_size), {face_size, face_size});
            CHECK(pcf_2x2_cube(clamped(atlas), T(face_size), glm::vec<3, T>(s, t, T(face)), receiver) ==
                  pcf_2x2(clamped(tile), glm::vec<2, T>(s, t), receiver));
        }
}

TEST_CASE("pcf_2x2_cube: wholly lit and wholly dark cubes show no line; what is nowhere is lit") {
    for (const float depth : {0.25f, 0.75f}) {
        const image<float> atlas({3 * face_size, 2 * face_size}, depth);
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i <= 64; ++i)
                for (const float edge : {0.0f, 0.3f, float(face_size) / 2, float(face_size)}) {
                    const float along = static_cast<float>(i) / 64.0f * float(face_size);
                    const auto at = [&](float s, float t) {
                        return pcf_2x2_cube(clamped(atlas), float(face_size), glm::vec3(s, t, face), 0.5f);
                    };
                    CHECK(at(edge, along) == (depth > 0.5f ? 1.0f : 0.0f));
                    CHECK(at(along, edge) == (depth > 0.5f ? 1.0f : 0.0f));
                }
        const float nan = std::nanf("");
        CHECK(pcf_2x2_cube(clamped(atlas), float(face_size), glm::vec3(nan, 1, 2), 0.5f) == 1.0f);
        CHECK(pcf_2x2_cube(clamped(atlas), float(face_size), glm::vec3(1, 1e9f, 2), 0.5f) == 1.0f);
        CHECK(pcf_2x2_cube(clamped(atlas), float(face_size), glm::vec3(1, 1, 2), 1.5f) == 1.0f);
        CHECK(pcf_2x2_cube(clamped(atlas), float(face_size), glm::vec3(1, 1, 2), nan) == 0.0f);
    }
}

TEST_CASE("cube_lit: a texel of its face or of the next one, none beyond a corner") {
    image<float> atlas({3 * face_size, 2 * face_size}, 0.0f);
    atlas[cube_tile(5, face_size) + glm::ivec2(0, 3)] = 1.0f;  // beyond +x's last column
    const auto of = [&](float s, float t) {
        return cube_lit(clamped(atlas), float(face_size), glm::vec3(s, t, 0), 0.5f);
    };
    CHECK(of(8, 3) == glm::vec2(1, 1));
    CHECK(of(8, 4) == glm::vec2(0, 1));
    CHECK(of(7, 3) == glm::vec2(0, 1));
    CHECK(of(8, 8) == glm::vec2(0, 0));
    CHECK(of(-1, 8) == glm::vec2(0, 0));
}
