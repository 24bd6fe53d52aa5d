// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>

#include <umbrage/shadow/warped_maps.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("warped_maps: bad input") {
    const cascade_fit<float> fit = shadow_scene::range(cpu_clip_space);
    const auto one =
        make_warped_cascades<1>(fit, {0.5f, 60.0f}, [](const auto& part) { return fit_light_space_perspective(part); });
    frustum<float> camera = fit.camera;
    CHECK_THROWS_WITH_AS(warped_maps(one, camera, 2.0f), "umbrage::warped_maps: share must be from 0 to 1; got 2",
                         std::invalid_argument);
    camera.direction = glm::vec3(0);
    CHECK_THROWS_WITH_AS(warped_maps(one, camera),
                         "umbrage::warped_maps: camera.direction must be finite and not zero; got (0, 0, 0)",
                         std::invalid_argument);
}
