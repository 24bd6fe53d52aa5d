// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>

#include <umbrage/clip_space.hpp>

using namespace umbrage;

namespace {

// as the interfaces define them
static_assert(opengl_clip_space == clip_space{handedness::right, depth_range::minus_one_to_one,
                                              depth_direction::forward, texture_origin::bottom});
static_assert(vulkan_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::forward,
                                              texture_origin::bottom});
static_assert(direct3d_clip_space == clip_space{handedness::left, depth_range::zero_to_one, depth_direction::forward,
                                                texture_origin::top});

}  // namespace

TEST_CASE("cleared_depth: that of the far plane") {
    for (clip_space clip : std::array{opengl_clip_space, vulkan_clip_space, direct3d_clip_space}) {
        CHECK(cleared_depth(clip) == 1.0f);
        clip.direction = depth_direction::reversed;
        CHECK(cleared_depth(clip) == 0.0f);
    }
}
