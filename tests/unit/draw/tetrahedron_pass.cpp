// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/draw/tetrahedron_pass.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/matrix.hpp>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../light/clip_spaces.hpp"

using namespace umbrage;

TEST_CASE(
    "rasterize_tetrahedron: a room's walls, each face's in its own triangle, the border too, in every convention") {
    const glm::vec3 position(0.5f, -0.3f, 0.2f), low(-3, -2, -4), high(2, 3, 4);
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    const std::vector<glm::uvec3> walls{{0, 1, 2}, {1, 2, 3}, {4, 5, 6}, {5, 6, 7}, {0, 1, 4}, {1, 4, 5},
                                        {2, 3, 6}, {3, 6, 7}, {0, 2, 4}, {2, 4, 6}, {1, 3, 5}, {3, 5, 7}};
    constexpr int size = 96;
    for (const clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const auto faces = make_tetrahedron_light<float>(
            {.position = position, .z_near = 0.25f, .z_far = 20, .map_size = size, .border = 3, .clip = clip});
        image<float> depth(glm::ivec2(size), cleared_depth(clip));
        rasterize_tetrahedron(depth.view(), {corners, walls}, faces);
        int wrong = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const auto face = std::size_t(tetrahedron_face_of(glm::vec2(x, y), float(size)));
                const glm::dmat4 back = glm::inverse(glm::dmat4(texture_matrix(faces[face], {size, size})));
                const glm::dvec3 d = through(back, glm::dvec3(x + 0.5, y + 0.5, 0.5)) - glm::dvec3(position);
                double share = 1e9;
                for (glm::length_t k = 0; k < 3; ++k)
                    share = std::min(share, ((d[k] > 0 ? high : low)[k] - position[k]) / d[k]);
                const glm::dvec3 wall = glm::dvec3(position) + share * d;
                const double expected = through(texture_matrix(faces[face], {size, size}), wall).z;
                wrong += !(std::abs(depth[{x, y}] - expected) < 1e-3);
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("rasterize_tetrahedron: keeps what is nearer of an earlier pass; a map that is not square is refused") {
    const std::vector<glm::vec3> corners{{-9, -2, -9}, {9, -2, -9}, {0, -2, 9}};
    const std::vector<glm::uvec3> floor{{0, 1, 2}};
    const auto faces = make_tetrahedron_light<float>({.map_size = 32, .clip = cpu_clip_space});
    image<float> depth({32, 32}, 0.25f);
    rasterize_tetrahedron(depth.view(), {corners, floor}, faces);
    for (const float d : depth.texels()) CHECK(d == 0.25f);
    image<float> wide({32, 16}, 1.0f);
    CHECK_THROWS_AS(rasterize_tetrahedron(wide.view(), {corners, floor}, faces), std::invalid_argument);
}

TEST_CASE("rasterize_tetrahedron: instances are their meshes one by one; mirrored ones keep their faces") {
    const std::vector<glm::vec3> corners{{-1, -2, -1}, {2, -2, -1}, {0, -2, 1}},
        other{{1, -2, -1}, {-2, -2, -1}, {0, -2, 1}};
    const std::vector<glm::uvec3> front{{0, 2, 1}}, back{{0, 1, 2}};
    const auto faces = make_tetrahedron_light<float>({.map_size = 64, .clip = cpu_clip_space});
    glm::mat4 mirror(1);
    mirror[0][0] = -1;
    const std::vector<glm::mat4> both{glm::mat4(1), mirror};
    for (const cull_mode cull : {cull_mode::none, cull_mode::back, cull_mode::front}) {
        image<float> expected({64, 64}, 1.0f), got({64, 64}, 1.0f);
        rasterize_tetrahedron(expected.view(), {corners, front}, faces, cull);
        rasterize_tetrahedron(expected.view(), {other, back}, faces, cull);
        rasterize_tetrahedron(got.view(), {corners, front}, both, faces, cull);
        CHECK(std::ranges::equal(got.texels(), expected.texels()));
        const float cleared = 1.0f;
        CHECK((std::ranges::count(got.texels(), cleared) == 64 * 64) == (cull == cull_mode::front));
    }
}
