// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texel_units.hpp>

using namespace umbrage;

TEST_CASE("texel_units: edges along x and y, and depth, in maps of any shape and both ranges of depth") {
    for (const clip_space clip : {opengl_clip_space, vulkan_clip_space}) {
        const auto sun = make_directional_light<double>({.direction = {0, 0, -1},
                                                         .offset = 0,
                                                         .map_size = {64, 32},
                                                         .texels_per_unit = 16,
                                                         .z_near = 0,
                                                         .z_far = 4,
                                                         .clip = clip});
        CHECK(detail::texel_units(sun, {64, 32}, "f") == glm::dvec3(1.0 / 16, 1.0 / 16, 0.25));
        CHECK(detail::texel_units(sun, {128, 8}, "f") == glm::dvec3(1.0 / 32, 1.0 / 4, 0.25));
        const auto spot = make_spot_light<double>({.direction = {0, 0, -1}, .z_near = 1, .z_far = 2, .clip = clip});
        const glm::dvec3 wide = detail::texel_units(spot, {100, 400}, "f");
        CHECK(wide.x == doctest::Approx(4 * wide.y));
        CHECK(wide.z == doctest::Approx(2));  // z/w is 2 - 2 / w
    }
}
