// SPDX-License-Identifier: MIT
//
// What light and camera see of a scene, and where in the shadow map each sample of the picture looks, bias and all.
#pragma once

#include <algorithm>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/image.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <scene.hpp>
#include <surface.hpp>

#include "light.hpp"
#include "options.hpp"

namespace shadow_render {

using example::lanes;

[[nodiscard]] inline example::camera make_camera(const options& o, const example::scene& scene) {
    return example::make_camera({.target = scene.target,
                                 .azimuth = o.camera_azimuth,
                                 .elevation = o.camera_elevation,
                                 .distance = o.camera_distance,
                                 .fov = o.fov,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height)});
}

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

/// The point to look up instead of the surface itself, so that no plane shadows itself.
/// @param texels  along the normal where light grazes
[[nodiscard]] inline glm::vec3 lifted(glm::vec3 position, glm::vec3 face_normal, const light& l, float texels) {
    const float w = l.w(position);
    const glm::vec3 way = l.way(position, w);
    return position +
           umbrage::normal_offset(face_normal, l.direction, way, umbrage::texels_to_world(texels, l.units, w), 0.0f);
}

/// What `lifted` needs for a filter.
[[nodiscard]] inline float automatic_bias(float reach) {
    return umbrage::offset_width(reach + umbrage::snapping_reach<float>, 1.0f);
}

/// Where each sample looks into the map, in texels, and the depth that it compares with; the bias is part of both.
struct receivers {
    umbrage::image<float> x, y, depth;

    explicit receivers(glm::ivec2 size, glm::vec3 value = umbrage::project_coordinate(glm::vec4(0)))  // lit in any map
        : x(size, value.x), y(size, value.y), depth(size, value.z) {}

    [[nodiscard]] umbrage::receiver_planes planes() const { return {x, y, depth}; }
};

/// @param texels    what `lifted` takes
/// @param below     how far the encoding may answer below the depth it was given
/// @param parallel  as the library's functions take it
template <class ParallelFor>
[[nodiscard]] receivers receivers_of(const view& v, int map_size, float texels, float below, ParallelFor&& parallel) {
    constexpr float rounding = 0x1p-18f;  // the depth pass and we compute the same depth, in float
    const glm::mat4 world_to_texels = umbrage::texture_matrix(v.lamp.space, glm::ivec2(map_size));
    receivers out(v.seen.size());
    const auto row = [&](int y) {
        float *const to_x = out.x.view().row(y), *const to_y = out.y.view().row(y),
                     *const to_depth = out.depth.view().row(y);
        example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
            const example::seen_triangle on = v.triangle(triangle);
            for (int x = first; x < last; x += lanes) {
                example::vectors weights, at;
                on.locate({x, y}, weights, at);
                for (int i = 0; i < lanes; ++i) at.set(i, lifted(at[i], on.face_normal(at[i]), v.lamp, texels));
                for (int i = 0; i < lanes; ++i)
                    at.set(i, umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, at[i])));
                for (int i = 0; i < lanes; ++i) at.z[i] = umbrage::biased(v.lamp.even_depth(at.z[i]), rounding + below);
                const int count = std::min(lanes, last - x);
                std::copy_n(at.x, count, to_x + x);
                std::copy_n(at.y, count, to_y + x);
                std::copy_n(at.z, count, to_depth + x);
            }
        });
    };
    parallel(v.seen.size().y, [&](int first, int last) {
        for (int y = first; y < last; ++y) row(y);
    });
    return out;
}

}  // namespace shadow_render
