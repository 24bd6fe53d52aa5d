// SPDX-License-Identifier: MIT
//
// What rays say of a receiver: lit, where no other surface lies on the light's side of its plane within the filter's
// reach; dark, where one surface stops every ray from the reach, farther from the plane than the bias hides.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "beam.hpp"

namespace joints {

/// Bounds of a receiver's visibility. Both are 1 where it is lit and 0 where it is dark.
struct verdict {
    float least = 0, most = 1;

    [[nodiscard]] bool is_lit() const { return least >= 1; }
    [[nodiscard]] bool is_dark() const { return most <= 0; }
    [[nodiscard]] bool is_open() const { return least <= 0 && most >= 1; }
    [[nodiscard]] bool holds(float visibility) const { return visibility >= least && visibility <= most; }
    bool operator==(const verdict&) const = default;
};
inline constexpr verdict fully_lit{1, 1}, fully_dark{0, 0};

/// What rays say of a receiver in one map.
/// @param reach    texels that the filter reads around it, with what a rasterizer and rounding move
/// @param stated   peter_panning_distance of the shadow there
/// @param clips    true where casters before the near plane are left out
[[nodiscard]] inline verdict verdict_of(const proof::traced_map& map, const proof::ray_light& light,
                                        const std::vector<surface>& all, const receiver& r, double reach, double stated,
                                        bool clips) {
    const surface& own = all[r.own];
    const glm::dvec3 p(r.point);
    const std::optional<beam> b = beam::make(map, light, own, p, reach);
    if (!b) return {};
    const glm::vec2 own_slope = map.slope(glm::vec3(own.normal), p);
    // Texels of slope by which a caster's own plane, or the receiver's below it, exceeds what is stated: along both
    // axes, or for a disc.
    const auto steeper = [&](glm::vec2 slope) {
        const auto sum = [](glm::vec2 v) { return double(std::abs(v.x) + std::abs(v.y)); };
        const glm::vec2 apart = slope - own_slope;
        const double along_axes = std::max(sum(slope), sum(apart)) - sum(own_slope);
        const double along_disc = double(std::max(glm::length(slope), glm::length(apart)) - glm::length(own_slope));
        return std::max({0.0, along_axes, along_disc});
    };
    bool is_lit = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (k == r.own) continue;
        if (!b->meets(all[k], map, clips)) continue;
        is_lit = false;
        if (!b->is_stopped_by(all[k], map, clips)) continue;
        const std::optional<glm::dvec3> hit = b->hits(all[k], glm::dvec3(0));
        if (!hit) continue;
        double more = reach * steeper(map.slope(glm::vec3(all[k].normal), *hit + p));
        if (map.bends()) more = std::max(0.0, b->rise_of(all[k], map) - b->own_rise(map));
        if (map.depth(p) - std::max(map.depth(*hit + p), 0.0) > stated + more) return fully_dark;
    }
    return is_lit ? fully_lit : verdict{};
}

}  // namespace joints
