// SPDX-License-Identifier: MIT
//
// What light and camera see of a scene.
#pragma once

#include <cstdint>

#include <umbrage/core/image.hpp>

#include <camera.hpp>
#include <scene.hpp>
#include <surface.hpp>

#include "light.hpp"
#include "options.hpp"

namespace shadow_render {

[[nodiscard]] inline example::camera make_camera(const options& o, const example::scene& scene) {
    return example::make_camera({.target = o.target.value_or(scene.target),
                                 .azimuth = o.camera_azimuth,
                                 .elevation = o.camera_elevation,
                                 .distance = o.camera_distance,
                                 .fov = o.fov,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height),
                                 .z_near = scene.z_near,
                                 .z_far = scene.z_far});
}

using example::lanes;

/// What light and camera see.
struct view {
    const example::scene& scene;
    light lamp;
    example::camera camera;
    umbrage::image<std::uint32_t> seen;  ///< triangle behind each sample of the picture

    [[nodiscard]] example::seen_triangle triangle(std::uint32_t index) const {
        return {scene, camera, seen.size(), index};
    }
};

}  // namespace shadow_render
