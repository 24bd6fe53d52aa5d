// SPDX-License-Identifier: MIT
#include "default_scene.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <umbrage/image_ops/rasterize.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <light.hpp>
#include <options.hpp>
#include <scene.hpp>

#include "data.hpp"

namespace bench {

shadowed_scene default_scene(int radius) {
    const shadow_render::options o;
    const example::scene scene = example::default_scene();
    const shadow_render::light light = shadow_render::make_light(o, scene);
    const umbrage::mesh_view mesh = example::view_of(scene.geometry);

    shadowed_scene out{umbrage::image<float>(map_size, umbrage::cleared_depth(light.space.clip)),
                       umbrage::image<glm::vec3>(screen, umbrage::project_coordinate(glm::vec4(0)))};
    umbrage::rasterize_depth(out.map, mesh, light.world_to_clip(), light.space.clip);
    for (float& depth : out.map.texels()) depth = light.even_depth(depth);

    const example::camera camera =
        example::make_camera({.target = scene.target, .azimuth = o.camera_azimuth, .elevation = o.camera_elevation,
                              .distance = o.camera_distance, .fov = o.fov,
                              .aspect = static_cast<float>(screen.x) / static_cast<float>(screen.y)});
    const auto seen = example::camera_pass(scene.geometry, camera, screen);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, map_size);
    const float reach = 1.42f * (static_cast<float>(radius) + 0.5f);
    for (int y = 0; y < screen.y; ++y)
        for (int x = 0; x < screen.x; ++x) {
            if (seen[{x, y}] == example::nothing) continue;
            const example::surface s = example::surface_at(scene, camera, seen, {x, y});
            const float cosine = glm::dot(s.face_normal, light.direction), sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
            const glm::vec3 off = s.position + s.face_normal * (reach * sine * light.texel_world(s.position, map_size.x));
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, off));
            out.receivers[{x, y}] = {p.x, p.y, light.even_depth(p.z) - 0x1p-18f};
        }
    return out;
}

}  // namespace bench
