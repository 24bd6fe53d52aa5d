// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/light/point/cube_atlas.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("cube_atlas_texel, cube_atlas_direction: back to the face, and to the texel's middle", T, float,
                   double) {
    for (const int size : {1, 2, 5, 32767})
        for (int face = 0; face < 6; ++face)
            for (const glm::ivec2 texel : {glm::ivec2(0), glm::ivec2(size - 1, 0), glm::ivec2(size / 2, size - 1)}) {
                CAPTURE(size);
                CAPTURE(face);
                const glm::vec<2, T> in_atlas(cube_tile(face, size) + texel);
                CHECK(cube_atlas_texel(in_atlas, T(size)) == glm::vec<3, T>(glm::vec<2, T>(texel), T(face)));
                const glm::vec<3, T> at = cube_coordinate(cube_atlas_direction(in_atlas, T(size)));
                CHECK(at.z == T(face));
                CHECK(glm::abs(at.x * T(size) - T(texel.x) - T(0.5)) < T(0.01));
                CHECK(glm::abs(at.y * T(size) - T(texel.y) - T(0.5)) < T(0.01));
            }
}
