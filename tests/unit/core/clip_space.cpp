// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/core/clip_space.hpp>

#include "../light/clip_spaces.hpp"
#include "../light/setups.hpp"

using namespace umbrage;

TEST_CASE("clip_space: the named ones are what their names say") {
    static_assert(opengl_clip_space == clip_space{handedness::right, depth_range::minus_one_to_one,
                                                  depth_direction::forward, texture_origin::bottom});
    static_assert(vulkan_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::forward,
                                                  texture_origin::bottom});
    static_assert(direct3d_clip_space == clip_space{handedness::left, depth_range::zero_to_one,
                                                    depth_direction::forward, texture_origin::top, 8});
    static_assert(opengl_clip_space.subpixel_bits == 4 && cpu_clip_space.subpixel_bits == 8);
    static_assert(webgpu_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::forward,
                                                  texture_origin::top});
    static_assert(metal_clip_space == webgpu_clip_space);
    static_assert(unity_clip_space == clip_space{handedness::left, depth_range::zero_to_one, depth_direction::reversed,
                                                 texture_origin::top});
    static_assert(unity_opengl_clip_space == clip_space{handedness::left, depth_range::minus_one_to_one,
                                                        depth_direction::forward, texture_origin::bottom});
    static_assert(unreal_clip_space == unity_clip_space);
    static_assert(godot_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::reversed,
                                                 texture_origin::bottom});
    static_assert(cpu_clip_space == clip_space{handedness::right, depth_range::zero_to_one, depth_direction::forward,
                                               texture_origin::bottom, 8});
    for (const named_clip_space& each : clip_spaces) CHECK(each.value.range != depth_range::unset);
    CHECK(opengl_clip_space != vulkan_clip_space);
}

TEST_CASE("cleared_depth: of the far plane") {
    CHECK(cleared_depth({}) == 1.0f);
    CHECK(cleared_depth(opengl_clip_space) == 1.0f);
    CHECK(cleared_depth({.direction = depth_direction::reversed}) == 0.0f);
}

TEST_CASE("handedness: a mesh keeps its winding in all sixteen conventions, as under GLM's matrices") {
    std::mt19937 random(12);
    std::uniform_real_distribution<double> coordinate(-4, 4);
    for (clip_space clip : all_clip_spaces()) {
        CAPTURE(to_string(clip));
        const bool right = clip.hand == handedness::right, zo = clip.range == depth_range::zero_to_one;
        const glm::dvec3 position(1, 9, 2), direction(-0.2, -1, 0.3), target = position + direction, up(0, 1, 0);
        const auto spot = make_spot_light<double>(
            {.position = position, .direction = direction, .outer_angle_radians = 0.7, .clip = clip});
        const auto sun = make_directional_light<double>({.direction = direction, .clip = clip});
        const auto fitted =
            fit_directional_light<double>({.direction = direction, .receivers = bounding_box<double>{}, .clip = clip});
        const auto perspective = right ? (zo ? glm::perspectiveRH_ZO<double> : glm::perspectiveRH_NO<double>)
                                       : (zo ? glm::perspectiveLH_ZO<double> : glm::perspectiveLH_NO<double>);
        const glm::dmat4 theirs = perspective(1.4, 1, 0.1, 100) *
                                  (right ? glm::lookAtRH(position, target, up) : glm::lookAtLH(position, target, up));
        int seen = 0, turned = 0, unlike = 0;
        for (int i = 0; i < 500; ++i) {
            const auto point = [&] { return glm::dvec3(coordinate(random), coordinate(random), coordinate(random)); };
            const glm::dvec3 a = point(), b = point(), c = point();
            // towards whoever sees a to b to c go counter-clockwise in a right-handed world, clockwise in a left-handed
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const auto counter_clockwise = [&](const glm::dmat4& m) {
                const glm::dvec2 p(through(m, a)), q(through(m, b)), r(through(m, c));
                return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) > 0;
            };
            const bool to_spot = glm::dot(normal, position - a) > 0, to_sun = glm::dot(normal, direction) < 0;
            const bool in_spot = counter_clockwise(spot.projection * spot.view);
            turned += in_spot != (to_spot == right);
            turned += counter_clockwise(sun.projection * sun.view) != (to_sun == right);
            turned += counter_clockwise(fitted.projection * fitted.view) != (to_sun == right);
            unlike += in_spot != counter_clockwise(theirs);
            seen += to_spot;
        }
        CHECK(turned == 0);
        CHECK(unlike == 0);
        CHECK(seen > 100);
        CHECK(seen < 400);
    }
}

TEST_CASE("handedness: Direct3D's view and projection are glm's left-handed ones") {
    const auto light = make_spot_light<double>({.position = {3, 8, -2},
                                                .direction = {-1, -3, 0.5},
                                                .outer_angle_radians = 0.7,
                                                .z_near = 0.5,
                                                .z_far = 40,
                                                .clip = direct3d_clip_space});
    const glm::dmat4 view = glm::lookAtLH(glm::dvec3(3, 8, -2), glm::dvec3(2, 5, -1.5), glm::dvec3(0, 1, 0));
    const glm::dmat4 projection = glm::perspectiveLH_ZO(1.4, 1.0, 0.5, 40.0);
    for (int c = 0; c < 4; ++c) {
        CHECK(glm::length(light.view[c] - view[c]) < 1e-14);
        CHECK(glm::length(light.projection[c] - projection[c]) < 1e-14);
    }
}
