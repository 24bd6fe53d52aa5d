// SPDX-License-Identifier: MIT
//
// Shadows by rays: slow, and independent of everything that the shadow map does. Told to by --rays, the programs
// compare themselves with it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <scene.hpp>

namespace example {

class ray_tracer {
public:
    explicit ray_tracer(const mesh& m) : mesh_(m) {
        for (std::size_t first = 0; first < m.triangles.size(); first += bundle) {
            const std::span<const glm::uvec3> some(&m.triangles[first], std::min(bundle, m.triangles.size() - first));
            glm::vec3 low = m.positions[some[0].x], high = low;
            for (glm::uvec3 t : some)
                for (int i = 0; i < 3; ++i) {
                    low = glm::min(low, m.positions[t[i]]);
                    high = glm::max(high, m.positions[t[i]]);
                }
            balls_.push_back({some, 0.5f * (low + high), 0.5f * glm::length(high - low)});
        }
    }

    /// Whether a triangle lies on the way.
    /// @param way  of length one
    [[nodiscard]] bool blocked(glm::vec3 from, glm::vec3 way, float distance) const {
        for (const ball& b : balls_) {
            const glm::vec3 to = b.centre - from;
            const float along = glm::dot(to, way);
            if (along < -b.radius || glm::dot(to, to) - along * along > b.radius * b.radius * 1.001f) continue;
            for (glm::uvec3 t : b.triangles)
                if (hits(mesh_.positions[t.x], mesh_.positions[t.y], mesh_.positions[t.z], from, way, distance)) return true;
        }
        return false;
    }

private:
    static constexpr std::size_t bundle = 32;
    struct ball {
        std::span<const glm::uvec3> triangles;
        glm::vec3 centre;
        float radius;
    };

    /// Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997.
    static bool hits(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 from, glm::vec3 way, float distance) {
        const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(way, ac);
        const float det = glm::dot(ab, p);
        if (det == 0) return false;
        const glm::vec3 s = (from - a) / det, q = glm::cross(s, ab);
        const float u = glm::dot(s, p), v = glm::dot(way, q), t = glm::dot(ac, q);
        return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < distance;
    }

    const mesh& mesh_;
    std::vector<ball> balls_;
};

}  // namespace example
