// SPDX-License-Identifier: MIT
//
// Rays against a mesh: slow, and independent of everything that a shadow map does.
//
//     const example::ray_tracer rays(scene.geometry);
//     const bool dark = rays.blocked(point, way_to_light, distance);
//
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "scene.hpp"

namespace example {

class ray_tracer {
public:
    /// @param m   kept by reference
    explicit ray_tracer(const mesh& m);

    /// True when a triangle lies on the way.
    /// @param way  direction of length 1
    [[nodiscard]] bool blocked(glm::vec3 from, glm::vec3 way, float distance) const;

private:
    /// A box around some triangles. The boxes inside it follow, up to `next`.
    struct box {
        glm::vec3 low, high;
        std::size_t first, count;  ///< triangles of its own: only the innermost have some
        std::size_t next;
    };
    void add(std::size_t first, std::size_t last);

    const mesh& mesh_;
    std::vector<glm::uvec3> triangles_;
    std::vector<box> boxes_;
};

}  // namespace example
