// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/core/scalar.hpp>
#include <umbrage/images/mesh.hpp>

using namespace umbrage;

TEST_CASE("model_to_clip: the product in double, rounded once") {
    glm::mat4 camera(1), model(1);
    camera[3][0] = -1e6f;
    camera[0][0] = 3;
    model[3][0] = 333333.375f;
    CHECK(model_to_clip(camera, model)[3][0] == 0.125f);  // 3 * 333333.375 is no float
    model[1][1] = 1e30f;
    camera[1][1] = 1e30f;
    CHECK_FALSE(is_finite(model_to_clip(camera, model)[1][1]));
}
