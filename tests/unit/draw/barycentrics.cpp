// SPDX-License-Identifier: MIT
#include <umbrage/draw/barycentrics.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

namespace {

using umbrage::triangle_weights;

struct one_triangle {
    std::vector<glm::vec3> positions{{-1, -1, -1}, {-1, 1, -1}, {3, 0, -3}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}};

    operator umbrage::mesh_view() const { return {positions, triangles}; }
};

const glm::mat4 wide_camera = glm::perspectiveRH_ZO(glm::radians(90.0f), 1.0f, 0.1f, 100.0f);

}  // namespace

TEST_CASE("triangle_weights: by hand, with rows from the bottom and from the top") {
    for (auto origin : {umbrage::texture_origin::bottom, umbrage::texture_origin::top}) {
        const bool top = origin == umbrage::texture_origin::top;
        const triangle_weights weights({2, 2}, one_triangle{}, wide_camera,
                                       {.range = umbrage::depth_range::zero_to_one, .origin = origin}, 0);
        // w of 1, 1 and 3: x / w = (-(1 - c) + 3 c) / (1 + 2 c) is -1/2 for c = 1/10 and 1/2 for c = 1/2
        const glm::vec3 left = weights({0, top ? 1 : 0}), right = weights({1, top ? 0 : 1});
        CHECK(left.z == doctest::Approx(0.1));
        CHECK(left.x - left.y == doctest::Approx(0.6));
        CHECK(right.x == 0.0f);  // outside: -1/4, 3/4 and 1/2, of which the positive ones count
        CHECK(right.y == doctest::Approx(0.6));
        CHECK(right.z == doctest::Approx(0.4));
    }
}

TEST_CASE("triangle_weights: what has no area or is not finite counts as its first vertex") {
    one_triangle m;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        m.positions[1].y = bad;
        CHECK(triangle_weights({2, 2}, m, wide_camera, umbrage::cpu_clip_space, 0)({0, 0}) == glm::vec3(1, 0, 0));
    }
    m.positions = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    CHECK(triangle_weights({2, 2}, m, wide_camera, umbrage::cpu_clip_space, 0)({1, 1}) == glm::vec3(1, 0, 0));
}

TEST_CASE("triangle_weights, barycentrics: refuse what is no triangle of the mesh, and an unset clip, by their names") {
    one_triangle m;
    m.triangles.push_back({0, 1, 7000});
    const auto both = [&](umbrage::clip_space clip, unsigned triangle, const std::string& rest) {
        CHECK_THROWS_WITH_AS((void)triangle_weights({2, 2}, m, wide_camera, clip, triangle),
                             ("umbrage::triangle_weights: " + rest).c_str(), std::invalid_argument);
        CHECK_THROWS_WITH_AS((void)umbrage::barycentrics({2, 2}, m, wide_camera, clip, {0, 0}, triangle),
                             ("umbrage::barycentrics: " + rest).c_str(), std::invalid_argument);
    };
    both(umbrage::cpu_clip_space, 1, "mesh.triangles must be indices of positions; got (0, 1, 7000)");
    both(umbrage::cpu_clip_space, 2, "triangle must be an index of mesh.triangles; got 2");
    std::string unset;
    try {
        umbrage::detail::require_given(umbrage::clip_space{}, "f");
    } catch (const std::invalid_argument& error) { unset = error.what(); }
    both({}, 0, unset.substr(std::string("umbrage::f: ").size()));
}
