// SPDX-License-Identifier: MIT
//
// What film strips share: a camera that walks, how a surface is looked up in a map, and pictures under such look-ups.
#pragma once

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include <camera.hpp>
#include <scene.hpp>
#include <srgb.hpp>
#include <stability.hpp>
#include <surface.hpp>

#include "options.hpp"
#include "shade.hpp"
#include "sheet.hpp"

namespace shadow_render {

/// Of a film: half as many where thousands of things are drawn.
[[nodiscard]] inline int frames_of(const example::scene& scene) { return scene.parts.empty() ? 24 : 12; }

/// Where a surface is in a frame's maps, and its light.
using film_look_up = std::function<example::placed_point(const example::surface&)>;

/// What is looked up for a surface by pcf_2x2: a point nearer to a directional light, so that no plane shadows itself,
/// whatever warp the map has.
template <umbrage::real T>
[[nodiscard]] glm::vec<3, T> biased(const glm::mat<4, 4, T>& to_texels, glm::vec3 to_light,
                                    const example::surface& at) {
    const glm::vec<3, T> world(at.position), normal(at.face_normal), direction(-to_light);
    const T reach = T(umbrage::filters::pcf_2x2{}.reach()) + umbrage::rasterizer_snap<T>;
    const auto here = umbrage::light_units_at(to_texels, direction, world);
    const T width = umbrage::offset_width(reach, here.units.x);
    const T bias = umbrage::kernel_bias(normal, direction, direction, width, T(20)) + reach * here.drift_world;
    return world - bias * direction;
}

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

/// Calls use(pixel, surface) for what a camera sees.
template <class Use>
void for_each_surface(const options& o, const example::scene& scene, const example::camera& camera, Use&& use) {
    const auto seen = example::camera_pass(scene.geometry, camera, {o.width, o.height});
    for (glm::ivec2 p{0}; p.y < o.height; ++p.y)
        for (p.x = 0; p.x < o.width; ++p.x)
            if (seen[p] != example::nothing) use(p, surface_at(scene, camera, seen, p));
}

constexpr glm::vec3 mark(0.9f, 0.1f, 0.1f);  ///< red

/// What the camera sees, with marks where a surface has another light than in `then`, as far as bytes tell.
[[nodiscard]] inline picture photograph(const options& o, const example::scene& scene, const example::camera& camera,
                                        glm::vec3 to_light, const film_look_up& lit, const film_look_up& then = {}) {
    picture out({o.width, o.height});
    for (glm::ivec2 p{0}; p.y < o.height; ++p.y)
        for (p.x = 0; p.x < o.width; ++p.x)
            out[p] = example::to_srgb(sky(static_cast<float>(p.y) / static_cast<float>(o.height)));
    for_each_surface(o, scene, camera, [&](glm::ivec2 p, const example::surface& at) {
        const example::placed_point in = lit(at);
        const bool other = then && std::abs(then(at).visibility - in.visibility) >= 1.0 / 256;
        out[p] = other ? umbrage::store_unorm(mark)
                       : example::to_srgb(shaded(at.color, at.normal, glm::dot(at.normal, to_light),
                                                 in.map < 0 ? 1.0f : static_cast<float>(in.visibility)));
    });
    return out;
}

}  // namespace shadow_render
