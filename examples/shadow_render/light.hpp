// SPDX-License-Identifier: MIT
//
// A light that the options place, in the numbers that each stage asks for.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <umbrage/depth/kinds.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/shade/lighting.hpp>

#include <camera.hpp>

#include "options.hpp"

namespace shadow_render {

struct light {
    bool spot = true;
    glm::vec3 position, direction;  ///< a directional light has no position
    float cos_outer = 0, z_near = 0, z_far = 1;
    umbrage::light_space<float> space{};

    [[nodiscard]] glm::mat4 world_to_clip() const { return space.projection * space.view; }

    [[nodiscard]] glm::vec3 to_light(glm::vec3 p) const { return spot ? glm::normalize(position - p) : -direction; }

    /// Depth that grows evenly with distance, which is what few bits need: z/w already does in a directional map.
    [[nodiscard]] float even_depth(float depth) const {
        return spot ? umbrage::linear_depth(umbrage::view_z_from_depth(depth, z_near, z_far), 1 / z_far) : depth;
    }

    [[nodiscard]] float cone(glm::vec3 p) const {
        return spot ? umbrage::spot_cone(direction, p - position, cos_outer) : 1.0f;
    }

    /// Edge of a texel's footprint at a point, across the light, in world units.
    [[nodiscard]] float texel_world(glm::vec3 p, int map_size) const {
        const float distance = spot ? glm::dot(p - position, direction) : 1.0f;
        const float half = 1 / std::min(space.projection[0][0], space.projection[1][1]);
        return 2 * half * std::max(distance, 0.0f) / static_cast<float>(map_size);
    }
};

[[nodiscard]] inline light make_light(const options& o, const example::scene& scene) {
    const glm::vec3 towards = example::direction_at(o.azimuth, o.elevation);
    const glm::vec3 up = example::direction_at(o.azimuth, o.elevation + 90);  // never parallel
    light out{.spot = o.light == light_kind::spot,
              .position = scene.target + o.distance * towards,
              .direction = -towards};
    if (!out.spot) {
        out.space = umbrage::fit_directional_light<float>(
            {.direction = out.direction, .up = up, .low = scene.low, .high = scene.high,
             .clip = example::picture_clip});
        return out;
    }

    // Planes as close as the scene allows.
    const glm::vec3 middle = 0.5f * (scene.low + scene.high), half = 0.5f * (scene.high - scene.low);
    const float centre = glm::dot(middle - out.position, out.direction);
    const float reach = glm::dot(half, glm::abs(out.direction));
    out.z_far = 1.01f * (centre + reach);
    out.z_near = std::max(0.99f * (centre - reach), 0.01f * out.z_far);
    const float outer_angle = glm::radians(o.cone / 2);
    out.cos_outer = std::cos(outer_angle);
    out.space = umbrage::make_spot_light<float>({.position = out.position,
                                                 .direction = out.direction,
                                                 .up = up,
                                                 .outer_angle_radians = outer_angle,
                                                 .z_near = out.z_near,
                                                 .z_far = out.z_far,
                                                 .clip = example::picture_clip});
    return out;
}

}  // namespace shadow_render
