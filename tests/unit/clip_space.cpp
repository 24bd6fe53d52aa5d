// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/clip_space.hpp>

using namespace umbrage;

TEST_CASE("clip_space: the named ones are what their names say") {
    static_assert(opengl_clip_space == clip_space{handedness::right, depth_range::minus_one_to_one,
                                                  depth_direction::forward, texture_origin::bottom});
    static_assert(vulkan_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::forward,
                                                  texture_origin::bottom});
    static_assert(direct3d_clip_space == clip_space{handedness::left, depth_range::zero_to_one,
                                                    depth_direction::forward, texture_origin::top});
    CHECK(opengl_clip_space != vulkan_clip_space);
}

TEST_CASE("cleared_depth: of the far plane") {
    CHECK(cleared_depth({}) == 1.0f);
    CHECK(cleared_depth(opengl_clip_space) == 1.0f);
    CHECK(cleared_depth({.direction = depth_direction::reversed}) == 0.0f);
}
