// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/tetrahedron.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/filter/pcf/hard.hpp>

#include "../clip_spaces.hpp"
#include "../directions.hpp"

using namespace umbrage;

namespace {

constexpr double radian = 180 / std::numbers::pi;

glm::dvec3 on_map(glm::dvec3 direction) {
    const glm::dvec3 at = tetrahedron_coordinate(direction);
    return {tetrahedron_texel(at, 1.0, 0.0), at.z};
}

}  // namespace

TEST_CASE("tetrahedron_normal: of length one, each at 109.47 degrees to the others") {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const double cosine = glm::dot(tetrahedron_normal<double>(i), tetrahedron_normal<double>(j));
            CHECK(std::abs(cosine - (i == j ? 1.0 : -1.0 / 3)) < 1e-15);
        }
}

TEST_CASE(
    "tetrahedron_face, tetrahedron_coordinate, tetrahedron_view_z: the greatest of normals . direction; every "
    "direction within its triangle, whose corners the other faces look away from") {
    std::mt19937 random(1);
    int outside = 0, other_face = 0;
    double apart = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec3 d = directions::any(random), at = tetrahedron_coordinate(d);
        int greatest = 0;
        for (int face = 1; face < 4; ++face)
            if (glm::dot(tetrahedron_normal<double>(face), d) > glm::dot(tetrahedron_normal<double>(greatest), d))
                greatest = face;
        other_face += tetrahedron_face(d) != greatest || at.z != greatest;
        outside += !(at.y >= 0 && std::abs(at.x) <= 1 - at.y + 1e-15);
        apart = worse(apart, std::abs(tetrahedron_view_z(d) - glm::dot(tetrahedron_normal<double>(greatest), d)));
        // what the face's corners, weighted, come to: apex, and the base's at s = -1 and 1
        const int other[]{2, 2, 0, 0};
        glm::dvec3 apex = -tetrahedron_normal<double>(greatest ^ 1), low = -tetrahedron_normal<double>(other[greatest]);
        glm::dvec3 high = -tetrahedron_normal<double>(other[greatest] + 1);
        if (glm::dot(glm::cross(tetrahedron_normal<double>(greatest), apex), high - low) < 0) std::swap(low, high);
        const glm::dvec3 sum = apex * at.y + low * ((1 - at.y - at.x) / 2) + high * ((1 - at.y + at.x) / 2);
        apart = worse(apart, glm::distance(glm::normalize(sum), glm::normalize(d)));
    }
    CHECK(outside == 0);
    CHECK(other_face == 0);
    CHECK(apart < 1e-14);
}

TEST_CASE("tetrahedron_coordinate: Liao's angles, a frustum tilted from a face's normal around its corners") {
    const glm::dvec3 apex = -tetrahedron_normal<double>(1), low = -tetrahedron_normal<double>(2);
    const glm::dvec3 high = -tetrahedron_normal<double>(3), base = glm::normalize(low + high);
    CHECK(tetrahedron_coordinate(glm::mix(apex, tetrahedron_normal<double>(0), 1e-12)).y == doctest::Approx(1));
    CHECK(tetrahedron_coordinate(glm::mix(base, tetrahedron_normal<double>(0), 1e-12)).y < 1e-11);
    CHECK(tetrahedron_coordinate(glm::mix(low, tetrahedron_normal<double>(0), 1e-12)).x == doctest::Approx(1));
    CHECK(tetrahedron_coordinate(glm::mix(high, tetrahedron_normal<double>(0), 1e-12)).x == doctest::Approx(-1));
    const glm::dvec3 forward = glm::normalize(apex + base);
    const double height = std::acos(glm::dot(apex, base)) * radian;
    const double width = 2 * std::atan2(glm::length(low - high) / 2, glm::dot(low, forward)) * radian;
    CHECK(std::abs(height - 125.26438968) < 1e-8);
    CHECK(std::abs(width - 143.98570868) < 1e-8);
    CHECK(std::abs(std::acos(glm::dot(forward, tetrahedron_normal<double>(0))) * radian - 7.897) < 5e-4);
}

TEST_CASE("tetrahedron_coordinate: over an edge lies the neighbor, from either corner as far") {
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int k = 0; k < 4; ++k) {
                const int l = 6 - i - j - k;
                if (i == j || j == k || i == k) continue;
                // the edge between faces i and j ends where k and l look away from
                for (const double share : {0.1, 0.5, 0.8}) {
                    const glm::dvec3 on_edge =
                        -glm::mix(tetrahedron_normal<double>(k), tetrahedron_normal<double>(l), share);
                    const auto step = [&](int face) { return on_edge + 1e-9 * tetrahedron_normal<double>(face); };
                    CHECK(tetrahedron_face(step(i)) == i);
                    CHECK(tetrahedron_face(step(j)) == j);
                    const auto weight = [&](int face, int corner) {  // of a corner, on one face's coordinates
                        const glm::dvec3 at = tetrahedron_coordinate(step(face));
                        const glm::dvec3 end = tetrahedron_coordinate(
                            glm::mix(-tetrahedron_normal<double>(corner), tetrahedron_normal<double>(face), 1e-9));
                        return end.y > 0.5 ? at.y : (1 - at.y + at.x * end.x) / 2;
                    };
                    CHECK(std::abs(weight(i, l) - share) < 1e-7);
                    CHECK(std::abs(weight(i, l) - weight(j, l)) < 1e-7);
                }
            }
}

TEST_CASE("tetrahedron_coordinate: no direction, or a NaN, is lit") {
    const image<float> map({16, 16}, 0.0f);
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    for (const glm::vec3 bad : {glm::vec3(0), glm::vec3(nan, 0, 1), glm::vec3(0, nan, 1), glm::vec3(0, 0, nan),
                                glm::vec3(infinity), glm::vec3(infinity, 0, 1)}) {
        const glm::vec3 at = tetrahedron_coordinate(bad);
        CHECK(at.z >= 0);
        CHECK(at.z <= 3);
        CHECK(hard(clamped(map), tetrahedron_texel(at, 16.0f, 1.0f), 0.5f) == 1.0f);
    }
}

TEST_CASE(
    "tetrahedron_coordinate: texels in a face's middle hold 27 times what those at its corners do; 10.4 n^2 of "
    "them are as dense as a cube's 6 n^2") {
    for (int face = 0; face < 4; ++face) {
        const glm::dvec3 normal = tetrahedron_normal<double>(face);
        const double middle = directions::solid_angle(normal, on_map);
        for (int other = 0; other < 4; ++other) {
            if (other == face) continue;
            const glm::dvec3 corner = glm::mix(-tetrahedron_normal<double>(other), normal, 1e-4);
            CHECK(middle / directions::solid_angle(corner, on_map) == doctest::Approx(27).epsilon(0.01));
        }
        const double cube_middle = 4;  // of a face, whose s and t are half of tangents
        CHECK(middle / cube_middle == doctest::Approx(10.4).epsilon(0.001));
    }
}

TEST_CASE("tetrahedron_texel, tetrahedron_face_of: within its own triangle, a border aside") {
    std::mt19937 random(2);
    constexpr double size = 64;
    int outside = 0, near_side = 0;
    for (const double border : {0.0, 3.0})
        for (int i = 0; i < 20000; ++i) {
            const glm::dvec3 at = tetrahedron_coordinate(directions::any(random));
            const glm::dvec2 texel = tetrahedron_texel(at, size, border);
            for (const glm::dvec2 tap : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
                const glm::dvec2 p = texel + tap * (border - 1e-9), off = p - size / 2;
                outside += border > 0 && (glm::any(glm::lessThan(p, glm::dvec2(0))) ||
                                          glm::any(glm::greaterThan(p, glm::dvec2(size))));
                const bool in_column = std::abs(off.y) >= std::abs(off.x) - 1e-9;
                outside +=
                    border > 0 && !(in_column == (at.z < 1.5) || std::abs(std::abs(off.y) - std::abs(off.x)) < 1e-6);
                near_side += std::abs(std::abs(off.y) - std::abs(off.x)) < 0.2;
            }
            if (border > 1) outside += tetrahedron_face_of(glm::floor(texel), size) != int(at.z);
        }
    CHECK(outside == 0);
    CHECK(near_side > 100);  // none too wide
    int texels[4]{};
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 6; ++x) ++texels[tetrahedron_face_of(glm::vec2(x, y), 6.0f)];
    CHECK(texels[0] == 12);
    CHECK(texels[1] == 12);
    CHECK(texels[2] == 6);
    CHECK(texels[3] == 6);
    CHECK(tetrahedron_face_of(glm::vec2(3, 1), 6.0f) == 0);
    CHECK(tetrahedron_face_of(glm::vec2(1, 3), 6.0f) == 3);
    CHECK(tetrahedron_face_of(glm::vec2(1, 1), 5.0f) == 0);
    CHECK(tetrahedron_face_of(glm::vec2(3, 2), 5.0f) == 2);
}
