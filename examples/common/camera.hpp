// SPDX-License-Identifier: MIT
//
// The camera pass: which triangle is seen through each sample. What is seen of it: surface.hpp.
//
//     example::camera camera = example::make_camera({.target = scene.target, .aspect = 1.5f});
//     umbrage::image<std::uint32_t> seen = example::camera_pass(scene.geometry, camera, size);
//
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/light/bounds.hpp>

#include "scene.hpp"

namespace example {

/// Pictures and maps of the examples: row 0 at the top, so that they are PNGs as they stand.
inline constexpr umbrage::clip_space picture_clip = umbrage::webgpu_clip_space;

/// Unit vector at the given angles in degrees: azimuth 0 is +z, 90 is +x; elevation 90 is +y.
[[nodiscard]] inline glm::vec3 direction_at(float azimuth, float elevation) {
    const float a = glm::radians(azimuth), e = glm::radians(elevation);
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

struct camera_setup {
    glm::vec3 target{0};
    float azimuth = 0, elevation = 25, distance = 7.5f;  ///< degrees, degrees, world units
    float fov = 35, aspect = 1;                          ///< vertical, degrees; width / height
    float z_near = 0.1f, z_far = 200.0f;                 ///< world units
};

struct camera {
    glm::vec3 position;
    glm::mat4 world_to_clip;
    umbrage::frustum<double> frustum;  ///< visible part of the world
};

[[nodiscard]] inline camera make_camera(const camera_setup& s) {
    const glm::vec3 back = direction_at(s.azimuth, s.elevation), position = s.target + s.distance * back;
    const glm::vec3 up = direction_at(s.azimuth, s.elevation + 90);  // never parallel to the line of sight
    const float tangent = std::tan(glm::radians(s.fov) / 2);
    return {
        position,
        glm::perspectiveRH_ZO(glm::radians(s.fov), s.aspect, s.z_near, s.z_far) * glm::lookAtRH(position, s.target, up),
        {position, -back, up, tangent * s.aspect, tangent, s.z_near, s.z_far}};
}

inline constexpr std::uint32_t nothing = ~std::uint32_t(0);

/// The depth pass of instances of a mesh, or of a mesh `once`; compiled once for all who need no threads.
void draw_depths(umbrage::image_view<float> depths, const umbrage::mesh_view& m, std::span<const glm::mat4> places,
                 const glm::mat4& world_to_clip);
inline const std::array once{glm::mat4(1)};

/// Number of the triangle seen at each sample, or `nothing`.
[[nodiscard]] umbrage::image<std::uint32_t> camera_pass(const mesh& m, const camera& c, glm::ivec2 size);

}  // namespace example
