// SPDX-License-Identifier: MIT
#include "ray_tracer.hpp"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace example {
namespace {

/// Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997.
bool hits(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 from, glm::vec3 way, float distance) {
    const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(way, ac);
    const float det = glm::dot(ab, p);
    if (det == 0) return false;
    const glm::vec3 s = (from - a) / det, q = glm::cross(s, ab);
    const float u = glm::dot(s, p), v = glm::dot(way, q), t = glm::dot(ac, q);
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < distance;
}

}  // namespace

ray_tracer::ray_tracer(const mesh& m) : mesh_(m), triangles_(m.triangles) { add(0, triangles_.size()); }

void ray_tracer::add(std::size_t first, std::size_t last) {
    constexpr std::size_t innermost = 6;
    const auto& p = mesh_.positions;
    box all{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest()), first, 0, 0};
    for (std::size_t i = first; i < last; ++i)
        for (int k = 0; k < 3; ++k) {
            all.low = glm::min(all.low, p[triangles_[i][k]]);
            all.high = glm::max(all.high, p[triangles_[i][k]]);
        }
    const glm::vec3 extent = all.high - all.low, rounding = 1e-5f * (glm::abs(all.low) + glm::abs(all.high) + extent);
    all.low -= rounding, all.high += rounding;
    const std::size_t at = boxes_.size();
    if (last - first <= innermost) all.count = last - first;
    boxes_.push_back(all);
    if (all.count == 0) {
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const auto center = [&](glm::uvec3 t) { return p[t.x][axis] + p[t.y][axis] + p[t.z][axis]; };
        const auto begin = triangles_.begin();
        const auto offset = [](std::size_t i) { return static_cast<std::ptrdiff_t>(i); };
        const std::size_t middle = (first + last) / 2;
        std::nth_element(begin + offset(first), begin + offset(middle), begin + offset(last),
                         [&](glm::uvec3 a, glm::uvec3 b) { return center(a) < center(b); });
        add(first, middle);
        add(middle, last);
    }
    boxes_[at].next = boxes_.size();
}

bool ray_tracer::blocked(glm::vec3 from, glm::vec3 way, float distance) const {
    glm::vec3 per_unit;  // time per unit along the axes; finite, so no product is NaN
    for (int i = 0; i < 3; ++i) per_unit[i] = glm::abs(way[i]) > 1e-20f ? 1 / way[i] : 1e20f;
    for (std::size_t i = 0; i < boxes_.size();) {
        const box& b = boxes_[i];
        const glm::vec3 to_low = (b.low - from) * per_unit, to_high = (b.high - from) * per_unit;
        const glm::vec3 in = glm::min(to_low, to_high), out = glm::max(to_low, to_high);
        const float enters = std::max({in.x, in.y, in.z, 0.0f}), leaves = std::min({out.x, out.y, out.z, distance});
        if (enters > leaves) {
            i = b.next;
            continue;
        }
        for (std::size_t t = b.first; t < b.first + b.count; ++t) {
            const glm::uvec3 of = triangles_[t];
            if (hits(mesh_.positions[of.x], mesh_.positions[of.y], mesh_.positions[of.z], from, way, distance))
                return true;
        }
        ++i;
    }
    return false;
}

}  // namespace example
