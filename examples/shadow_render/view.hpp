// SPDX-License-Identifier: MIT
//
// What light and camera see of a scene, and where in the shadow map each sample of the picture looks, bias and all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/image.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <scene.hpp>

#include "light.hpp"
#include "options.hpp"

namespace shadow_render {

[[nodiscard]] inline example::camera make_camera(const options& o, const example::scene& scene) {
    return example::make_camera({.target = scene.target,
                                 .azimuth = o.camera_azimuth,
                                 .elevation = o.camera_elevation,
                                 .distance = o.camera_distance,
                                 .fov = o.fov,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height)});
}

/// The point to look up instead of the surface itself, moved off it so that no texel the filter reads can shadow a
/// plane through it. With t the angle between normal and light axis, a texel's step across the map changes the depth
/// of the plane by as much as a move of sin(t) texels along its normal wins: so sin(t) times the farthest texel.
[[nodiscard]] inline glm::vec3 biased(const example::surface& s, const light& l, float texels, int map_size) {
    const float cosine = glm::dot(s.face_normal, l.direction);
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return s.position + s.face_normal * (texels * sine * l.texel_world(s.position, map_size));
}

/// What `biased` needs so that no plane shadows itself: the way to the corner of the filter's footprint.
[[nodiscard]] inline float automatic_bias(float reach) {
    constexpr float snapping = 1.0f / 128;  // the depth pass moves vertices by up to 1/512 texel
    return std::numbers::sqrt2_v<float> * (reach + snapping);
}

/// What light and camera see.
struct view {
    const example::scene& scene;
    light lamp;
    example::camera camera;
    umbrage::image<std::uint32_t> seen;  ///< triangle behind each sample of the picture

    [[nodiscard]] bool empty(glm::ivec2 sample) const { return seen[sample] == example::nothing; }
    [[nodiscard]] example::surface at(glm::ivec2 sample) const {
        return example::surface_at(scene, camera, seen, sample);
    }
};

/// Where each sample looks into the map, in texels, and the depth that it compares with; the bias is part of both.
/// @param texels  what `biased` takes
/// @param below   how far the encoding may answer below the depth it was given
/// @param step    called after each row
template <class Step>
[[nodiscard]] umbrage::image<glm::vec3> receivers_of(const view& v, int map_size, float texels, float below, Step&& step) {
    constexpr float rounding = 0x1p-18f;  // the depth pass and we compute the same depth, in float
    const glm::mat4 world_to_texels = umbrage::texture_matrix(v.lamp.space, glm::ivec2(map_size));
    const glm::ivec2 size = v.seen.size();
    umbrage::image<glm::vec3> receivers(size, umbrage::project_coordinate(glm::vec4(0)));  // lit in any map
    for (int y = 0; y < size.y; ++y, step())
        for (int x = 0; x < size.x; ++x) {
            const glm::ivec2 t(x, y);
            if (v.empty(t)) continue;
            const glm::vec3 point = biased(v.at(t), v.lamp, texels, map_size);
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, point));
            receivers[t] = {p.x, p.y, v.lamp.even_depth(p.z) - rounding - below};
        }
    return receivers;
}

}  // namespace shadow_render
