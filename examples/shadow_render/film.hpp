// SPDX-License-Identifier: MIT
//
// What film strips share: a camera that walks, maps of what it may see, and its pictures under look-ups of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/images/instances.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/stability.hpp>
#include <umbrage/light/texture_matrix.hpp>
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

/// Of a film: half as many where thousands of things are drawn.
[[nodiscard]] inline int frames_of(const example::scene& scene) { return scene.parts.empty() ? 24 : 12; }

/// Where a point of the world is in a frame's maps, and its light.
using point_look_up = std::function<umbrage::placed_point(glm::vec3)>;

/// What the camera does: it walks past the scene, and turns and nods as it does.
[[nodiscard]] inline example::camera camera_at(const options& o, const example::scene& scene, int frame) {
    const float at = static_cast<float>(frame) / static_cast<float>(frames_of(scene) - 1);
    const float walk = 0.12f * o.camera_distance * at;
    return example::make_camera({.target = scene.target + walk * glm::vec3(1, 0.1f, -0.6f),
                                 .azimuth = o.camera_azimuth + 25 * at,
                                 .elevation = o.camera_elevation + 6 * std::sin(9 * at),
                                 .distance = o.camera_distance,
                                 .fov = o.fov,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height),
                                 .z_near = scene.z_near,
                                 .z_far = scene.z_far});
}

/// What is looked up for a surface: a point some pixels above it. Nearer to it is acne's, as maps for a view have
/// texels that grow with the distance.
[[nodiscard]] inline glm::vec3 lifted(const options& o, const example::scene& scene, const example::surface& at) {
    const float distance = std::max(o.camera_distance, glm::distance(at.position, scene.target));
    return at.position + 0.007f * distance * at.face_normal;
}

/// Calls use(pixel, surface) for what a camera sees.
template <class Use>
void for_each_surface(const options& o, const example::scene& scene, const example::camera& camera, Use&& use) {
    const auto seen = example::camera_pass(scene.geometry, camera, {o.width, o.height});
    for (glm::ivec2 p{0}; p.y < o.height; ++p.y)
        for (p.x = 0; p.x < o.width; ++p.x)
            if (seen[p] != example::nothing) use(p, surface_at(scene, camera, seen, p));
}

/// A part of a map, in texels.
struct rectangle {
    glm::dvec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

    void add(glm::dvec2 texel) { low = glm::min(low, texel), high = glm::max(high, texel); }
};
[[nodiscard]] inline rectangle all_of(const umbrage::image<float>& map) { return {{0, 0}, glm::dvec2(map.size())}; }

/// What a scene is made of, each thing with its box. A scene's vertices are its parts', place by place.
struct instance {
    umbrage::mesh_view mesh;
    umbrage::bounding_box<float> box;
};
/// @param positions   of the scene's vertices, in whatever space it is to be drawn from
[[nodiscard]] inline std::vector<instance> instances_of(const example::scene& scene,
                                                        std::span<const glm::vec3> positions) {
    std::vector<instance> all;
    const auto add = [&](const umbrage::mesh_view& mesh) { all.push_back({mesh, umbrage::bounds_of(mesh)}); };
    for (const example::copies& part : scene.parts)
        for (std::size_t i = 0; i < part.places.size(); ++i) {
            add({positions.first(part.shape.positions.size()), part.shape.triangles});
            positions = positions.subspan(part.shape.positions.size());
        }
    if (scene.parts.empty()) add({positions, scene.geometry.triangles});
    return all;
}

/// The depth pass of the instances that a part of a map, and two texels around it, may see: of none where nothing has
/// been added to the part.
inline void draw_seen(umbrage::image<float>& map, const rectangle& part, const std::vector<instance>& instances,
                      const glm::mat4& to_clip, umbrage::clip_space clip) {
    if (part.low.x > part.high.x) return;
    const glm::dvec2 middle = (part.low + part.high) * 0.5, half = (part.high - part.low) * 0.5 + 2.0;
    const glm::dmat4 to_texels = umbrage::texture_matrix<double>({glm::dmat4(1), glm::dmat4(1), clip}, map.size());
    glm::dmat4 to_part(1);  // its sides at -1 and 1
    for (glm::length_t i = 0; i < 2; ++i)
        to_part[i][i] = to_texels[i][i] / half[i], to_part[3][i] = (to_texels[3][i] - middle[i]) / half[i];
    const glm::mat4 to_its_clip(to_part * glm::dmat4(to_clip));
    for (const instance& i : instances)
        if (umbrage::may_mark(i.box, to_its_clip, clip)) umbrage::rasterize_depth(map, i.mesh, to_clip, clip);
}

constexpr glm::vec3 mark(0.9f, 0.1f, 0.1f);  ///< red

/// What the camera sees, with marks where a point has another light than in `then`.
[[nodiscard]] inline picture photograph(const options& o, const example::scene& scene, const example::camera& camera,
                                        glm::vec3 to_light, const point_look_up& lit, const point_look_up& then = {}) {
    picture out({o.width, o.height}, example::to_srgb(background));
    for_each_surface(o, scene, camera, [&](glm::ivec2 p, const example::surface& at) {
        const umbrage::placed_point in = lit(lifted(o, scene, at));
        if (then && then(lifted(o, scene, at)).visibility != in.visibility) {
            out[p] = umbrage::store_unorm8(mark);
            return;
        }
        out[p] = example::to_srgb(umbrage::diffuse_ambient(at.colour, ambient, glm::dot(at.normal, to_light),
                                                           in.map < 0 ? 1.0f : static_cast<float>(in.visibility)));
    });
    return out;
}

}  // namespace shadow_render
