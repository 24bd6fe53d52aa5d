// SPDX-License-Identifier: MIT
//
// Edges of shadows, for tests. A GPU may round to the other side of them.
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <surface.hpp>
#include <systems.hpp>

namespace viewer {

/// After the CPU's map with exact depth.
class silhouettes {
public:
    silhouettes(const example::shadow_system& s, glm::ivec2 size)
        : system_(s),
          scene_(example::make_scene(s)),
          camera_(example::make_camera(
              example::make_camera_setup(s, scene_, static_cast<float>(size.x) / static_cast<float>(size.y)))),
          seen_(example::camera_pass(scene_.geometry, camera_, size)),
          light_(example::make_light(s, scene_)),
          to_texels_(umbrage::texture_matrix(light_.space, s.map_size)),
          map_(s.map_size, umbrage::cleared_depth(light_.space.clip)) {
        umbrage::rasterize_depth(map_, example::view_of(scene_.geometry), light_.world_to_clip(), light_.space.clip);
        for (float& z : map_.texels()) z = light_.depth(s, z);
    }

    /// True when shadow takes another value somewhere within two texels of a pixel's surface, measured across the light
    /// and in the surface's own plane.
    [[nodiscard]] bool near(glm::ivec2 pixel) const {
        if (seen_[pixel] == example::nothing) return false;
        const example::surface at = example::surface_at(scene_, camera_, seen_, pixel);
        const glm::vec3 way = light_.spot ? glm::normalize(at.position - light_.position) : light_.direction;
        const float texel = light_.texel_world(at.position);
        const glm::vec3 up(0, 1, 0);
        const glm::vec3 side = glm::normalize(glm::cross(way, glm::abs(way.y) < 0.9f ? up : glm::vec3(1, 0, 0)));
        const glm::vec3 above = glm::cross(side, way);
        const bool here = lit(at, at.position);
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) {
                const glm::vec3 aside = texel * (static_cast<float>(i) * side + static_cast<float>(j) * above);
                const float along = -glm::dot(at.face_normal, aside) / glm::dot(at.face_normal, way);
                if (lit(at, at.position + aside + along * way) != here) return true;
            }
        return false;
    }

private:
    [[nodiscard]] bool lit(const example::surface& s, glm::vec3 position) const {
        const glm::vec3 point = example::lifted(system_, light_, position, s.face_normal);
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels_, point));
        const float receiver = umbrage::biased(light_.depth(system_, p.z), system_.epsilon);
        return light_.cone(position) * umbrage::hard(umbrage::clamped(map_), glm::vec2(p), receiver) > 0;
    }

    example::shadow_system system_;
    example::scene scene_;
    example::camera camera_;
    umbrage::image<std::uint32_t> seen_;
    example::light light_;
    glm::mat4 to_texels_;
    umbrage::image<float> map_;
};

}  // namespace viewer
