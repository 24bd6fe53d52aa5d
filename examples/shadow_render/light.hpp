// SPDX-License-Identifier: MIT
//
// A light that the options place, in the numbers that each stage asks for.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/lighting.hpp>
#include <umbrage/light/spot_light.hpp>

#include <camera.hpp>

#include "options.hpp"

namespace shadow_render {

struct light {
    glm::vec3 position, direction;
    float cos_outer = 0, z_near = 0, z_far = 1;  ///< a directional light has 0, 0 and 1
    umbrage::light_space<float> space{};
    glm::vec2 units{1};  ///< umbrage::make_light_units

    [[nodiscard]] glm::mat4 world_to_clip() const { return space.projection * space.view; }

    // Both kinds are computed and one is chosen, by a float: a branch would keep compilers from using vectors.
    [[nodiscard]] bool spot() const { return z_near > 0; }

    [[nodiscard]] glm::vec3 to_light(glm::vec3 p) const {
        const glm::vec3 back = -direction, way = glm::normalize(position - p);
        return {spot() ? way.x : back.x, spot() ? way.y : back.y, spot() ? way.z : back.z};
    }

    /// Depth that grows evenly with distance, which is what few bits need: z/w already does in a directional map.
    [[nodiscard]] float even_depth(float depth) const {
        const float even = umbrage::linear_depth(umbrage::view_z_from_depth(depth, z_near, z_far), 1 / z_far);
        return spot() ? even : depth;
    }

    /// The way back.
    [[nodiscard]] float projected_depth(float even) const {
        const float depth = umbrage::depth_from_view_z(even * z_far, z_near, z_far);
        return spot() ? depth : even;
    }

    [[nodiscard]] float cone(glm::vec3 p) const {
        const float inside = umbrage::spot_cone(direction, p - position, cos_outer);
        return spot() ? inside : 1.0f;
    }

    /// Distance along the axis of a spot: w of its shadow coordinates.
    [[nodiscard]] float w(glm::vec3 p) const {
        const float along = glm::dot(p - position, direction);
        return spot() ? along : 1.0f;
    }

    /// From the light to the point over w.
    [[nodiscard]] glm::vec3 way(glm::vec3 p, float w) const {
        const glm::vec3 from = (p - position) / w;
        return {spot() ? from.x : direction.x, spot() ? from.y : direction.y, spot() ? from.z : direction.z};
    }
};

[[nodiscard]] inline light make_light(const options& o, const example::scene& scene) {
    const glm::vec3 towards = example::direction_at(o.azimuth, o.elevation);
    const glm::vec3 up = example::direction_at(o.azimuth, o.elevation + 90);  // never parallel
    light out{.position = scene.target + o.distance * towards, .direction = -towards};
    if (o.light != light_kind::spot) {
        out.space =
            umbrage::fit_directional_light<float>({.direction = out.direction,
                                                   .up = up,
                                                   .receivers = umbrage::bounding_box<float>{scene.low, scene.high},
                                                   .clip = example::picture_clip});
        out.units = umbrage::make_light_units(out.space, glm::ivec2(o.map_size));
        return out;
    }

    // Planes as close as the scene allows.
    const glm::vec3 middle = 0.5f * (scene.low + scene.high), half = 0.5f * (scene.high - scene.low);
    const float center = glm::dot(middle - out.position, out.direction);
    const float reach = glm::dot(half, glm::abs(out.direction));
    out.z_far = 1.01f * (center + reach);
    out.z_near = std::max(0.99f * (center - reach), 0.01f * out.z_far);
    const float outer_angle = glm::radians(o.cone / 2);
    out.cos_outer = std::cos(outer_angle);
    out.space = umbrage::make_spot_light<float>({.position = out.position,
                                                 .direction = out.direction,
                                                 .up = up,
                                                 .outer_angle_radians = outer_angle,
                                                 .z_near = out.z_near,
                                                 .z_far = out.z_far,
                                                 .clip = example::picture_clip});
    out.units = umbrage::make_light_units(out.space, glm::ivec2(o.map_size));
    return out;
}

}  // namespace shadow_render
