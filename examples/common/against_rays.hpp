// SPDX-License-Identifier: MIT
//
// A picture's shadows of a light held against rays, for the examples' checks.
//
//     const example::ray_tracer rays(scene.geometry);
//     const example::against_rays counts(scene, rays, camera, size, light, 200, [&](auto p) { return lit(p); });
//
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "camera.hpp"
#include "ray_tracer.hpp"
#include "surface.hpp"

namespace example {

/// Pixels, of surfaces that face the light but for those all but parallel to it.
struct against_rays {
    int lit = 0, dark = 0;              ///< by rays
    int other_near = 0, other_far = 0;  ///< where the picture says something else; by distance from the camera
    int shadowed_sky = 0;

    /// @param rays     ray tracer of the scene. Making it takes longer than its queries
    /// @param light    towards a sun and 0, or a lamp's position and 1
    /// @param far      distance from which pixels count as far
    /// @param is_lit   pixel -> whether it is, in the picture
    template <class Lit>
    against_rays(const scene& s, const ray_tracer& rays, const camera& c, glm::ivec2 size, const glm::vec4& light,
                 float far, const Lit& is_lit) {
        const float everything = 2 * glm::distance(s.low, s.high);
        const auto seen = camera_pass(s.geometry, c, size);
        for (glm::ivec2 p{0}; p.y < size.y; ++p.y)
            for (p.x = 0; p.x < size.x; ++p.x) {
                if (seen[p] == nothing) {
                    shadowed_sky += !is_lit(p);
                    continue;
                }
                const surface at = surface_at(s, c, seen, p);
                const glm::vec3 way = glm::vec3(light) - light.w * at.position, to_light = glm::normalize(way);
                if (glm::dot(at.face_normal, to_light) < 0.1f) continue;
                const bool blocked = rays.blocked(at.position + 0.01f * at.face_normal, to_light,
                                                  light.w > 0 ? glm::length(way) : everything);
                (blocked ? dark : lit) += 1;
                if (is_lit(p) == blocked) (glm::distance(at.position, c.position) < far ? other_near : other_far) += 1;
            }
    }
};

}  // namespace example
