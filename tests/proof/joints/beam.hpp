// SPDX-License-Identifier: MIT
//
// The rays from a light to a part of a receiver's plane, and the surfaces that they meet.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "../traced_map.hpp"
#include "scene.hpp"

namespace joints {

/// Depths between a receiver and parts of a surface on the light's side of its plane.
struct blocking {
    double nearest, farthest;
    double clear;  ///< the least, from the part to the receiver or to its plane, whichever is nearer to the light
};

/// A convex polygon that planes cut. It has room for a surface's corners and one more for each plane.
class polygon {
public:
    void add(glm::dvec3 corner) { corners_.at(size_++) = corner; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const glm::dvec3* begin() const { return corners_.data(); }
    [[nodiscard]] const glm::dvec3* end() const { return corners_.data() + size_; }

    /// Leaves the part where a function that is linear up to a positive factor is above 0.
    template <class Distance>
    void cut(const Distance& distance) {
        std::array<double, most> at;
        std::size_t inside = 0;
        for (std::size_t i = 0; i < size_; ++i) inside += (at[i] = distance(corners_[i])) > 0;
        if (inside == 0) size_ = 0;
        if (inside == size_) return;
        const polygon whole = *this;
        size_ = 0;
        for (std::size_t i = 0; i < whole.size_; ++i) {
            const std::size_t next = i + 1 < whole.size_ ? i + 1 : 0;
            const glm::dvec3 a = whole.corners_[i], b = whole.corners_[next];
            if (at[i] > 0) add(a);
            if ((at[i] > 0) != (at[next] > 0)) add(a + (b - a) * (at[i] / (at[i] - at[next])));
        }
    }

private:
    static constexpr std::size_t most = 12;
    std::array<glm::dvec3, most> corners_;
    std::size_t size_ = 0;
};

/// The rays that reach the part of a receiver's plane within a filter's reach. Positions are relative to the receiver.
class beam {
public:
    /// @param own     surface that the receiver is on
    /// @param reach   texels to each side
    /// @param aside   texels from the receiver to the middle of the part
    /// @return        none where the plane is seen edge-on, or passes behind the light
    [[nodiscard]] static std::optional<beam> make(const proof::traced_map& map, const proof::ray_light& light,
                                                  const surface& own, glm::dvec3 p, double reach,
                                                  glm::dvec2 aside = glm::dvec2(0)) {
        beam b;
        b.light_ = light, b.from_ = p;
        const glm::dvec3 way = light.way(p);
        const double side = glm::dot(own.normal, way);
        if (std::abs(side) < 1e-3 * glm::length(way)) return std::nullopt;
        b.normal_ = own.normal * (side > 0 ? 1.0 : -1.0);
        b.offset_ = glm::dot(b.normal_, own.corners[0] - p);
        const glm::dvec4 h = map.placed(p), plane(b.normal_, -glm::dot(b.normal_, own.corners[0]));
        if (!(h.w > 0)) return std::nullopt;
        constexpr std::array<glm::dvec2, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto at = map.point_at(glm::dvec2(h) / h.w + aside + around[i] * reach, plane);
            if (!at || !(glm::dot(b.normal_, light.way(*at)) > 0)) return std::nullopt;
            b.corners_[i] = *at - p;
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec3 next = b.corners_[(i + 1) % 4] - b.corners_[i];
            glm::dvec3 n = glm::cross(next, b.way(b.corners_[i]));
            if (glm::dot(n, b.corners_[(i + 2) % 4] - b.corners_[i]) < 0) n = -n;
            b.sides_[i] = glm::normalize(n);
        }
        return b;
    }

    /// True when a part of a surface lies on the light's side of the plane within the beam, as far as a map draws it.
    [[nodiscard]] bool meets(const surface& s, const proof::traced_map& map, bool clips) const {
        return !part_of(s, map, clips).empty();
    }
    /// How far such a part lies before the receiver; none where there is no part.
    [[nodiscard]] std::optional<blocking> blocks(const surface& s, const proof::traced_map& map, bool clips) const {
        std::optional<blocking> all;
        const double own = map.depth(from_);
        for (const glm::dvec3& x : part_of(s, map, clips)) {
            const glm::dvec3 on_plane = x - way(x) * ((glm::dot(normal_, x) - offset_) / glm::dot(normal_, way(x)));
            const double here = std::max(map.depth(x + from_), 0.0), before = own - here;  // clamped to the near plane
            const double clear = std::min(own, map.depth(on_plane + from_)) - here;
            if (!all) all = {before, before, clear};
            all = {std::min(all->nearest, before), std::max(all->farthest, before), std::min(all->clear, clear)};
        }
        return all;
    }

    /// True when a surface stops all rays of the beam.
    [[nodiscard]] bool is_stopped_by(const surface& s, const proof::traced_map& map, bool clips) const {
        for (const glm::dvec3& corner : corners_) {
            const std::optional<glm::dvec3> hit = hits(s, corner);
            if (!hit || (clips && !(map.depth(*hit + from_) > 1e-5))) return false;
        }
        return true;
    }
    /// Depth by which the receiver's plane rises within the beam, or a surface that stops all rays.
    [[nodiscard]] double own_rise(const proof::traced_map& map) const {
        return rise(map, [](glm::dvec3 x) { return x; });
    }
    [[nodiscard]] double rise_of(const surface& s, const proof::traced_map& map) const {
        return rise(map, [&](glm::dvec3 x) { return *hits(s, x); });
    }
    /// Where the ray from a point to the light meets a surface.
    [[nodiscard]] std::optional<glm::dvec3> hits(const surface& s, glm::dvec3 x) const {
        const glm::dvec3 w = way(x);
        const double t = glm::dot(s.normal, s.corners[0] - from_ - x) / glm::dot(s.normal, w);
        if (!(t > 1e-9) || (light_.is_point && !(t < 1 - 1e-9)) || !std::isfinite(t)) return std::nullopt;
        const glm::dvec3 at = x + t * w;
        for (std::size_t i = 0; i < s.corners.size(); ++i) {
            const glm::dvec3 a = s.corners[i] - from_, b = s.corners[(i + 1) % s.corners.size()] - from_;
            if (glm::dot(glm::cross(b - a, at - a), s.normal) < 0) return std::nullopt;
        }
        return at;
    }

private:
    [[nodiscard]] glm::dvec3 way(glm::dvec3 x) const { return light_.way(from_ + x); }
    [[nodiscard]] polygon part_of(const surface& s, const proof::traced_map& map, bool clips) const {
        polygon part;
        for (const glm::dvec3& c : s.corners) part.add(c - from_);
        const double spare = 1e-9 * glm::length(corners_[0] - corners_[2]) + 1e-14 * glm::length(from_);
        part.cut([&](glm::dvec3 x) { return glm::dot(normal_, x) - offset_ - spare; });
        for (std::size_t i = 0; i < 4; ++i)
            part.cut([&](glm::dvec3 x) { return glm::dot(sides_[i], x - corners_[i]); });
        // What lies behind the light is cut off along the plane: a beam may see farther aside than a right angle.
        if (light_.is_point) part.cut([&](glm::dvec3 x) { return glm::dot(normal_, way(x)); });
        if (clips) part.cut([&](glm::dvec3 x) { return map.placed(x + from_).z + 1e-4 * map.placed(x + from_).w; });
        return part;
    }
    template <class Meet>
    [[nodiscard]] double rise(const proof::traced_map& map, const Meet& meet) const {
        double most = 0.0;
        for (const glm::dvec3& x : corners_) most = std::max(most, map.depth(meet(x) + from_));
        return most - map.depth(meet(glm::dvec3(0)) + from_);
    }

    proof::ray_light light_;
    glm::dvec3 from_{0}, normal_{0};
    double offset_ = 0;
    std::array<glm::dvec3, 4> corners_{}, sides_{};
};

}  // namespace joints
