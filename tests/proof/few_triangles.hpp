// SPDX-License-Identifier: MIT
//
// Scenes in which lights are compared with rays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/bounds.hpp>

namespace proof {

/// A ground and few triangles above it, all from one number, which goes on to give random numbers.
class few_triangles {
protected:
    explicit few_triangles(std::uint32_t number) : random_(number) {
        positions_ = {{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}};
        triangles_ = {{0, 1, 2}, {0, 2, 3}};
        while (triangles_.size() < 8) {
            const glm::vec3 middle = between({-2, 0.5f, -2}, {2, 3, 2});
            std::array<glm::vec3, 3> corner;
            for (glm::vec3& c : corner) c = middle + vector(-1.5f, 1.5f), c.y = std::max(c.y, 0.1f);
            if (glm::length(glm::cross(corner[1] - corner[0], corner[2] - corner[0])) < 1.0f) continue;
            const auto first = static_cast<unsigned>(positions_.size());
            positions_.insert(positions_.end(), corner.begin(), corner.end());
            triangles_.emplace_back(first, first + 1, first + 2);
        }
        for (const glm::vec3& p : positions_) box_.low = glm::min(box_.low, p), box_.high = glm::max(box_.high, p);
    }

    [[nodiscard]] float real(float low, float high) { return std::uniform_real_distribution(low, high)(random_); }
    /// Draws one number after the other: arguments of a call are evaluated in any order, and scenes are to be the same.
    [[nodiscard]] glm::vec3 between(const glm::vec3& low, const glm::vec3& high) {
        const float x = real(low.x, high.x), y = real(low.y, high.y), z = real(low.z, high.z);
        return {x, y, z};
    }
    [[nodiscard]] glm::vec3 vector(float low, float high) { return between(glm::vec3(low), glm::vec3(high)); }
    [[nodiscard]] glm::vec3 around(float distance) {  // above the ground
        const glm::vec3 way = vector(-1, 1);
        return glm::normalize(glm::vec3(way.x, std::abs(way.y) + 0.2f, way.z)) * distance;
    }

    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::size_t k) const {
        const glm::uvec3 t = triangles_[k];
        return {positions_[t.x], positions_[t.y], positions_[t.z]};
    }
    [[nodiscard]] glm::vec3 point_of(std::size_t k) {
        const auto [a, b, c] = corners(k);
        double u = real(0, 1), v = real(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        return glm::vec3(a + u * (b - a) + v * (c - a));
    }

    std::mt19937 random_;
    std::vector<glm::vec3> positions_;
    std::vector<glm::uvec3> triangles_;
    umbrage::bounding_box<float> box_{glm::vec3(1e9f), glm::vec3(-1e9f)};
};

}  // namespace proof
