// SPDX-License-Identifier: MIT
//
// Bounding volume hierarchy over a mesh, for millions of rays in double through thousands of triangles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "../ray_mesh.hpp"

namespace proof::picture {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// Triangle that a ray meets first, and its distance in lengths of the ray's way; `never` where it meets none.
struct ray_hit {
    double distance = never;
    std::size_t triangle = 0;
};

class ray_tree {
public:
    explicit ray_tree(const ray_mesh& mesh) : mesh_(&mesh) {
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) order_.push_back(k);
        build(0, order_.size());
    }

    /// First triangle between `from` and from + farthest way.
    [[nodiscard]] ray_hit first(glm::dvec3 from, glm::dvec3 way, double farthest = never) const {
        return search(from, way, farthest, false);
    }
    /// True when any triangle is in the way.
    [[nodiscard]] bool is_blocked(glm::dvec3 from, glm::dvec3 way, double farthest) const {
        return search(from, way, farthest, true).distance < farthest;
    }

private:
    static constexpr std::size_t leaf = 4;  // triangles: 2 to 8 are equally fast
    struct node {
        glm::dvec3 low, high;
        std::size_t begin, end;  // triangles of a leaf
        std::size_t right = 0;   // the second child, the first follows its parent; 0: a leaf
    };

    void build(std::size_t begin, std::size_t end) {
        glm::dvec3 low(never), high(-never), low_center(never), high_center(-never);
        for (std::size_t i = begin; i < end; ++i) {
            for (const glm::dvec3& c : mesh_->corners(order_[i])) low = glm::min(low, c), high = glm::max(high, c);
            low_center = glm::min(low_center, center(order_[i])),
            high_center = glm::max(high_center, center(order_[i]));
        }
        const std::size_t own = nodes_.size();
        nodes_.push_back({low, high, begin, end});
        if (end - begin <= leaf) return;
        const glm::dvec3 size = high_center - low_center;
        const glm::length_t axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const std::size_t middle = begin + (end - begin) / 2;
        const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
        std::nth_element(at(begin), at(middle), at(end),
                         [&](std::size_t a, std::size_t b) { return center(a)[axis] < center(b)[axis]; });
        build(begin, middle);
        nodes_[own].right = nodes_.size();
        build(middle, end);
    }
    [[nodiscard]] glm::dvec3 center(std::size_t k) const {
        const auto [a, b, c] = mesh_->corners(k);
        return (a + b + c) / 3.0;
    }

    [[nodiscard]] ray_hit search(glm::dvec3 from, glm::dvec3 way, double farthest, bool any) const {
        ray_hit found{farthest, 0};
        const glm::dvec3 inverse = 1.0 / way;
        std::size_t stack[64], depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const std::size_t own = stack[--depth];
            const node& n = nodes_[own];
            const glm::dvec3 a = (n.low - from) * inverse, b = (n.high - from) * inverse;
            const glm::dvec3 enters = glm::min(a, b), leaves = glm::max(a, b);
            const double enter = std::max({enters.x, enters.y, enters.z, 0.0});
            const double leave = std::min({leaves.x, leaves.y, leaves.z, found.distance});
            if (!(enter <= leave * (1 + 1e-12))) continue;
            if (n.right != 0) {
                stack[depth++] = n.right, stack[depth++] = own + 1;
                continue;
            }
            for (std::size_t i = n.begin; i < n.end; ++i) {
                const double at = mesh_->meets(order_[i], from, way);
                if (!(at > 0.0 && at < found.distance)) continue;
                found = {at, order_[i]};
                if (any) return found;
            }
        }
        return found;
    }

    const ray_mesh* mesh_;
    std::vector<std::size_t> order_{};
    std::vector<node> nodes_{};
};

}  // namespace proof::picture
