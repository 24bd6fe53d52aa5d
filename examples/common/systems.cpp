// SPDX-License-Identifier: MIT
#include "systems.hpp"

#include <utility>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>

namespace example {

scene make_scene(const shadow_system& s, const std::filesystem::path& mesh_file, up_axis up) {
    scene out = mesh_file.empty() ? solids_scene() : on_floor(load_mesh(mesh_file), up);
    for (glm::vec3& p : out.geometry.positions) p *= s.scene_scale;
    for (glm::vec3* p : {&out.low, &out.high, &out.target}) *p *= s.scene_scale;
    return out;
}

scene make_pane(const shadow_system& s) {
    const glm::vec3 low(-2.3f, 0, 0.75f), across(1.3f, 0, -0.75f), up(0, 1.15f, 0);
    mesh m;
    for (glm::vec3 corner : {low, low + across, low + across + up, low + up}) {
        m.positions.push_back(corner * s.scene_scale);
        m.normals.push_back(glm::normalize(glm::cross(across, up)));
        m.colors.emplace_back(0.55f, 0.75f, 0.80f);
    }
    m.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene out{.geometry = std::move(m)};
    find_bounds(out);
    return out;
}

light make_light(const shadow_system& s, const scene& scene, umbrage::clip_space clip) {
    const glm::vec3 towards = direction_at(s.azimuth, s.elevation);
    const glm::vec3 up = direction_at(s.azimuth, s.elevation + 90);  // turns with the light, never parallel to it
    light out{.spot = s.light == light_kind::spot, .direction = -towards};
    switch (s.light) {
        case light_kind::spot: {
            out.position = scene.target + s.distance * s.scene_scale * towards;
            const glm::vec3 middle = 0.5f * (scene.low + scene.high), half = 0.5f * (scene.high - scene.low);
            out.z_near = 0.1f;
            out.z_far =
                1.01f * (glm::dot(middle - out.position, out.direction) + glm::dot(half, glm::abs(out.direction)));
            const float angle = glm::radians(s.outer_angle);
            out.cos_outer = std::cos(angle);
            out.space = umbrage::make_spot_light<float>({.position = out.position,
                                                         .direction = out.direction,
                                                         .up = up,
                                                         .outer_angle_radians = angle,
                                                         .z_near = out.z_near,
                                                         .z_far = out.z_far,
                                                         .clip = clip});
            break;
        }
        case light_kind::fitted:
            out.space =
                umbrage::fit_directional_light<float>({.direction = out.direction,
                                                       .up = up,
                                                       .receivers = umbrage::bounding_box<float>{scene.low, scene.high},
                                                       .clip = clip});
            break;
        case light_kind::exercise:
            out.z_near = s.z_near;
            out.z_far = s.z_far;
            out.space = umbrage::make_directional_light<float>({.direction = out.direction,
                                                                .up = up,
                                                                .offset = s.offset,
                                                                .map_size = s.map_size,
                                                                .texels_per_unit = s.texels_per_unit,
                                                                .z_near = out.z_near,
                                                                .z_far = out.z_far,
                                                                .clip = clip});
            break;
    }
    out.units = umbrage::make_light_units(out.space, s.map_size);
    return out;
}

}  // namespace example
