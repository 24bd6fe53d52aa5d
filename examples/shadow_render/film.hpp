// SPDX-License-Identifier: MIT
//
// What film strips share: a camera's pictures under look-ups of shadow maps.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/images/instances.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/stability.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/unorm.hpp>

#include <camera.hpp>
#include <scene.hpp>
#include <srgb.hpp>
#include <surface.hpp>

#include "options.hpp"
#include "shade.hpp"
#include "sheet.hpp"

namespace shadow_render {

/// Where a point of the world is in a frame's maps, and its light.
using point_look_up = std::function<umbrage::placed_point(glm::vec3)>;

inline constexpr int frames = 24;

/// What the camera does: it walks past the scene, and turns and nods as it does.
[[nodiscard]] inline example::camera camera_at(const options& o, const example::scene& scene, int frame) {
    const float at = static_cast<float>(frame) / (frames - 1), walk = 0.12f * o.camera_distance * at;
    return example::make_camera({.target = scene.target + walk * glm::vec3(1, 0.1f, -0.6f),
                                 .azimuth = o.camera_azimuth + 25 * at,
                                 .elevation = o.camera_elevation + 6 * std::sin(9 * at),
                                 .distance = o.camera_distance,
                                 .fov = o.fov,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height),
                                 .z_near = scene.z_near,
                                 .z_far = scene.z_far});
}

/// How far points are lifted off their surfaces, world units: less than that is acne's.
[[nodiscard]] inline float lift(const options& o) { return 0.007f * o.camera_distance; }

[[nodiscard]] inline glm::vec3 lifted(const options& o, const example::surface& at) {
    return at.position + lift(o) * at.face_normal;
}

/// Calls use(pixel, surface) for what a camera sees.
template <class Use>
void for_each_surface(const options& o, const example::scene& scene, const example::camera& camera, Use&& use) {
    const auto seen = example::camera_pass(scene.geometry, camera, {o.width, o.height});
    for (glm::ivec2 p{0}; p.y < o.height; ++p.y)
        for (p.x = 0; p.x < o.width; ++p.x)
            if (seen[p] != example::nothing) use(p, surface_at(scene, camera, seen, p));
}

/// The depth pass of the instances that a map may see: a scene's vertices are its parts', place by place.
/// @param positions   of the scene's vertices, in the space that the matrix takes
inline void draw_seen(umbrage::image_view<float> map, const example::scene& scene, std::span<const glm::vec3> positions,
                      const glm::mat4& to_clip, umbrage::clip_space clip) {
    const auto draw = [&](const umbrage::mesh_view& mesh) {
        if (umbrage::may_mark(umbrage::bounds_of(mesh), to_clip, clip))
            umbrage::rasterize_depth(map, mesh, to_clip, clip);
    };
    for (const example::copies& part : scene.parts)
        for (std::size_t i = 0; i < part.places.size(); ++i) {
            draw({positions.first(part.shape.positions.size()), part.shape.triangles});
            positions = positions.subspan(part.shape.positions.size());
        }
    if (scene.parts.empty()) draw({positions, scene.geometry.triangles});
}

constexpr glm::vec3 mark(0.9f, 0.1f, 0.1f);  ///< red

/// What the camera sees, with marks where a point has another light than in `then`.
[[nodiscard]] inline picture photograph(const options& o, const example::scene& scene, const example::camera& camera,
                                        glm::vec3 to_light, const point_look_up& lit, const point_look_up& then = {}) {
    picture out({o.width, o.height}, example::to_srgb(background));
    for_each_surface(o, scene, camera, [&](glm::ivec2 p, const example::surface& at) {
        const umbrage::placed_point in = lit(lifted(o, at));
        if (then && then(lifted(o, at)).visibility != in.visibility) {
            out[p] = umbrage::store_unorm8(mark);
            return;
        }
        out[p] = example::to_srgb(umbrage::diffuse_ambient(at.colour, ambient, glm::dot(at.normal, to_light),
                                                           in.map < 0 ? 1.0f : static_cast<float>(in.visibility)));
    });
    return out;
}

}  // namespace shadow_render
