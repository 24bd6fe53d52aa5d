// SPDX-License-Identifier: MIT
//
// The camera pass: which triangle is seen through each sample, and the surface there.
//
//     example::camera camera = example::make_camera({.target = scene.target, .aspect = 1.5f});
//     umbrage::image<std::uint32_t> seen = example::camera_pass(scene.geometry, camera, size);
//     if (seen[texel] != example::nothing) example::surface s = example::surface_at(scene, camera, seen, texel);
//
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/image.hpp>
#include <umbrage/images/rasterize.hpp>

#include "scene.hpp"

namespace example {

/// Pictures and maps of the examples: row 0 at the top, so that they are PNGs as they stand.
inline constexpr umbrage::clip_space picture_clip{.origin = umbrage::texture_origin::top};

/// Unit vector at the given angles in degrees: azimuth 0 is +z, 90 is +x; elevation 90 is +y.
[[nodiscard]] inline glm::vec3 direction_at(float azimuth, float elevation) {
    const float a = glm::radians(azimuth), e = glm::radians(elevation);
    return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

struct camera_setup {
    glm::vec3 target{0};
    float azimuth = 0, elevation = 25, distance = 7.5f;  ///< degrees, degrees, world units
    float fov = 35, aspect = 1;                          ///< vertical, degrees; width / height
};

struct camera {
    glm::vec3 position;
    glm::mat4 world_to_clip;
};

[[nodiscard]] inline camera make_camera(const camera_setup& s) {
    const glm::vec3 position = s.target + s.distance * direction_at(s.azimuth, s.elevation);
    const glm::vec3 up = direction_at(s.azimuth, s.elevation + 90);  // never parallel to the line of sight
    return {position, glm::perspectiveRH_ZO(glm::radians(s.fov), s.aspect, 0.1f, 200.0f) *
                          glm::lookAtRH(position, s.target, up)};
}

[[nodiscard]] inline umbrage::mesh_view view_of(const mesh& m) { return {m.positions, m.triangles}; }

inline constexpr std::uint32_t nothing = ~std::uint32_t(0);

/// Number of the triangle seen at each sample, or `nothing`.
[[nodiscard]] inline umbrage::image<std::uint32_t> camera_pass(const mesh& m, const camera& c, glm::ivec2 size) {
    umbrage::image<float> depth(size, umbrage::cleared_depth(picture_clip));
    umbrage::image<std::uint32_t> seen(size, nothing);
    umbrage::rasterize(size, view_of(m), c.world_to_clip, picture_clip,
                       [&](glm::ivec2 texel, float z, std::uint32_t triangle) {
                           if (z > depth[texel] || (z == depth[texel] && triangle > seen[texel])) return;
                           depth[texel] = z;
                           seen[texel] = triangle;
                       });
    return seen;
}

/// A point that the camera sees. Both normals point to the camera's side of the triangle.
struct surface {
    glm::vec3 position;
    glm::vec3 face_normal;  ///< of the flat triangle, which is what the shadow map holds
    glm::vec3 normal;       ///< interpolated, for shading
    glm::vec3 colour;
};

[[nodiscard]] inline surface surface_at(const scene& s, const camera& c, const umbrage::image<std::uint32_t>& seen,
                                        glm::ivec2 texel) {
    const mesh& m = s.geometry;
    const std::uint32_t triangle = seen[texel];
    const glm::uvec3 t = m.triangles[triangle];
    const glm::vec3 w = umbrage::barycentrics(seen.size(), view_of(m), c.world_to_clip, picture_clip, texel, triangle);
    const auto blend = [&](const auto& of) { return w.x * of[t.x] + w.y * of[t.y] + w.z * of[t.z]; };

    surface out;
    out.position = blend(m.positions);
    out.colour = triangle < s.floor_triangles ? floor_colour(out.position) : blend(m.colours);
    const glm::vec3 a = m.positions[t.x], b = m.positions[t.y], d = m.positions[t.z];
    const glm::vec3 to_camera = c.position - out.position;
    const auto towards = [](glm::vec3 v, glm::vec3 side) { return glm::dot(v, side) < 0 ? -v : v; };
    const auto unit = [](glm::vec3 v, glm::vec3 otherwise) {
        const float length = glm::length(v);
        return length > 0 && length < std::numeric_limits<float>::infinity() ? v / length : otherwise;
    };
    out.face_normal = towards(unit(glm::cross(b - a, d - a), {0, 1, 0}), to_camera);
    out.normal = towards(unit(blend(m.normals), out.face_normal), out.face_normal);
    return out;
}

}  // namespace example
