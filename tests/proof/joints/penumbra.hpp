// SPDX-License-Identifier: MIT
//
// What rays say of a receiver whose light is partly hidden. A filter over a disc counts points of it that are lit. Rays
// decide most points, so the visibility lies between the share that they find lit and the share that they do not find
// dark. The disc of PCSS is as wide as rays to the light's rim pass its blockers. DPCF has the disc of the search, and
// steepens the share of hidden points to that width.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/filter/pcf/disc.hpp>

#include "choices.hpp"
#include "verdict.hpp"

namespace joints {

/// Ellipse of a penumbra in a map: (x + shear y, y) of a disc's points, times its radii.
struct ellipse_of_light {
    glm::dvec2 radii;
    double shear;
};

/// Texels of a penumbra's ellipse for each unit of depth between a blocker and its receiver, by rays from the receiver
/// to the middle and to the rim of the light. A light faces along its map's axis.
/// @param size   of the light: radius, or tangent of half the angle under which it is seen
/// @return       none where the map holds no texel around the point
[[nodiscard]] inline std::optional<ellipse_of_light> penumbra_of_depth(const proof::traced_map& map,
                                                                       const proof::ray_light& light, double size,
                                                                       glm::dvec3 p) {
    const glm::dvec3 way = light.way(p);
    const auto w = [&](glm::dvec3 at) { return map.placed(at).w; };
    const glm::dvec3 ahead(w({1, 0, 0}) - w({0, 0, 0}), w({0, 1, 0}) - w({0, 0, 0}), w({0, 0, 1}) - w({0, 0, 0}));
    const glm::dvec3 axis = light.is_point ? ahead : way;
    const glm::dvec3 side = glm::normalize(glm::cross(
                         axis, std::abs(axis.x) < 0.5 * glm::length(axis) ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0))),
                     other = glm::normalize(glm::cross(axis, side));
    // Texels of the rim of a disc around a point, across the axis, for each unit of its radius.
    const auto rim = [&](glm::dvec3 at) -> std::optional<ellipse_of_light> {
        const glm::dvec4 h = map.placed(at), across(axis, -glm::dot(axis, at));
        const auto moved = [&](double x, double y) {
            return map.point_at(glm::dvec2(h) / h.w + glm::dvec2(x, y), across);
        };
        constexpr double off = 1.0 / 16;  // a texel of a strong warp bends: by whole ones it is 1 % off
        const auto left = moved(-off, 0), right = moved(off, 0), below = moved(0, -off), above = moved(0, off);
        if (!left || !right || !below || !above) return std::nullopt;
        const glm::dvec3 a = (*right - *left) / (2 * off), b = (*above - *below) / (2 * off);  // world units a texel
        const glm::dmat2 to_texels =
            glm::inverse(glm::dmat2(glm::dot(a, side), glm::dot(a, other), glm::dot(b, side), glm::dot(b, other)));
        const glm::dvec2 x(to_texels[0][0], to_texels[1][0]), y(to_texels[0][1], to_texels[1][1]);
        const double rows = glm::length(y), area = std::abs(glm::determinant(to_texels));
        return ellipse_of_light{{area / rows, rows}, glm::dot(x, y) / area};
    };
    const auto here = rim(p);
    if (!here) return std::nullopt;
    const glm::dvec3 blocker = p + way * (light.is_point ? 0.25 : 16 / std::min(here->radii.x, here->radii.y));
    const double aside = light.is_point ? size * (1 - w(blocker) / w(p)) : size * glm::length(blocker - p);
    auto all = rim(blocker);
    if (all) all->radii *= aside / (map.depth(p) - map.depth(blocker));
    return all;
}

struct range {
    double low, high;
};
/// Radii of an ellipse along x and y, texels.
struct radii_range {
    glm::dvec2 low, high;
};

/// A look of a filter that hardens contacts.
struct soft_look {
    filter_choice filter;
    glm::ivec2 pixel;  ///< which rotates the disc
    double reach;      ///< of the filter, texels
    double beside;     ///< texels from a point to the center of its texel, with what a rasterizer moves
    double hidden;     ///< depth before a receiver that its bias may hide
};

/// What rays say of a receiver in one map, by the points of its filter's disc.
class penumbra_rays {
public:
    penumbra_rays(const proof::traced_map& map, const proof::ray_light& light, const std::vector<surface>& all,
                  const receiver& r, bool clips, const soft_look& look)
        : map_(map), light_(light), own_(all[r.own]), at_(r.point), clips_(clips), look_(look) {
        const auto penumbra = penumbra_of_depth(map, light, look.filter.light_size, at_);
        if (!penumbra) return;
        of_depth_ = penumbra->radii, shear_ = penumbra->shear;
        const glm::dvec4 turn = glm::dvec4(umbrage::disc_rotation(glm::vec2(look.pixel))) / 64.0;
        for (const glm::ivec2 point : umbrage::detail::points_of_disc(look.filter.points)) {
            const glm::dvec2 p = glm::dvec2(point) / 16.0;
            const double x = turn.x * p.x + turn.y * p.y, y = turn.z * p.x + turn.w * p.y;
            points_.emplace_back(x + shear_ * y, y);
        }
        if (!(std::abs(shear_) < 8)) points_.clear();  // which filters cut
        const std::optional<beam> wide = beam::make(map, light, own_, at_, look.reach);
        if (!wide) points_.clear();
        for (std::size_t k = 0; k < all.size() && wide; ++k)
            if (k != r.own && wide->meets(all[k], map, clips)) blockers_.push_back(&all[k]);
    }

    [[nodiscard]] verdict visibility() const {
        const double z = map_.depth(at_);
        // The search is as wide as the penumbra of a blocker at the near plane.
        const radii_range search = radii({z, z});
        range apart{1e300, 0};
        bool finds = false;
        for (const glm::dvec2 point : points_) {
            const std::optional<beam> b = beam_of(point, search);
            if (!b) return {};
            for (const surface* s : blockers_) {
                const std::optional<blocking> here = b->blocks(*s, map_, clips_);
                if (!here || here->farthest < 0) continue;
                apart = {std::min(apart.low, std::max(here->nearest, 0.0)), std::max(apart.high, here->farthest)};
                finds |= here->clear > look_.hidden && b->is_stopped_by(*s, map_, clips_);
            }
        }
        if (points_.empty()) return {};
        if (apart.low > apart.high) return fully_lit;
        const radii_range wide = radii(apart);
        const std::optional<range> dark = dark_share(look_.filter.is_dpcf() ? search : wide);
        if (!dark) return {};
        if (look_.filter.is_dpcf()) {
            const auto both = [](glm::dvec2 r) { return r.x + r.y; };
            const range ratio{both(wide.low) / both(search.high), both(wide.high) / both(search.low)};
            return steepened(*dark, ratio);
        }
        // The search may have found no blocker: then all counts as lit.
        return {least_of(1 - dark->high), finds ? most_of(1 - dark->low) : 1.0f};
    }

private:
    /// Radii of penumbras, texels: those of a light in world units, and the stated accuracy of pcss.
    [[nodiscard]] radii_range radii(const range& apart) const {
        constexpr double off = 1.0 / 256;
        const glm::dvec2 code = of_depth_ * (16.0 / 65536);  // sixteenths of a texel per code of depth
        const glm::dvec2 low = of_depth_ * (16 * (apart.low - look_.hidden) * (1 - off)) - 1.0 - code;
        const glm::dvec2 high = of_depth_ * (16 * (apart.high + look_.hidden) * (1 + off)) + 2.0 * code;
        const double least = std::floor(16 * float(look_.filter.least_radius())),
                     most = std::floor(16 * float(look_.filter.most_radius)) / std::sqrt(1 + shear_ * shear_);
        const auto cut = [&](glm::dvec2 r) { return glm::min(glm::max(r, least), most) / 16.0; };
        return {cut(low), cut(high)};
    }
    /// Rays of the texel under a point of the disc, for all radii of a range.
    [[nodiscard]] std::optional<beam> beam_of(glm::dvec2 point, const radii_range& radius) const {
        const glm::dvec2 spread = glm::abs(point) * (0.5 * (radius.high - radius.low));
        return beam::make(map_, light_, own_, at_, look_.beside + std::max(spread.x, spread.y),
                          point * (0.5 * (radius.low + radius.high)));
    }
    /// Share of the disc's points that blockers hide; none where rays say nothing.
    [[nodiscard]] std::optional<range> dark_share(const radii_range& radius) const {
        double lit = 0, dark = 0;
        for (const glm::dvec2 point : points_) {
            const std::optional<beam> b = beam_of(point, radius);
            if (!b) return std::nullopt;
            bool meets = false, stops = false;
            for (const surface* s : blockers_)
                if (const std::optional<blocking> here = b->blocks(*s, map_, clips_)) {
                    meets = true;
                    stops |= here->clear > look_.hidden && b->is_stopped_by(*s, map_, clips_);
                }
            lit += !meets, dark += stops;
        }
        const auto all = double(points_.size());
        return range{dark / all, 1 - lit / all};
    }
    /// Bounds of a visibility, with what blending two maps rounds.
    [[nodiscard]] static float least_of(double v) { return v >= 1 ? 1.0f : float(v - 0x1p-20); }
    [[nodiscard]] static float most_of(double v) { return v <= 0 ? 0.0f : float(v + 0x1p-20); }

    /// Visibility of DPCF, by the formula of hardened_kernel. More hidden points never give a lighter result, and the
    /// ratio of widths blends two values: the extremes are at the ends of both ranges.
    [[nodiscard]] static verdict steepened(const range& share, const range& ratio) {
        const auto kernel = [](double x, double blend) {
            const double u = 2 * x - 1, steep = 1 - std::pow(1 - std::abs(u), 3);
            return (0.5 + std::copysign(0.5 * steep, u)) * (1 - blend) + x * blend;
        };
        const double low = std::max(ratio.low - 1.0 / 256, 0.0), high = std::min(ratio.high, 1.0);  // floor to 1/256
        return {least_of(1 - std::max(kernel(share.high, low), kernel(share.high, high))),
                most_of(1 - std::min(kernel(share.low, low), kernel(share.low, high)))};
    }

    const proof::traced_map& map_;
    const proof::ray_light& light_;
    const surface& own_;
    glm::dvec3 at_;
    bool clips_;
    soft_look look_;
    glm::dvec2 of_depth_{0};  ///< radii for each unit of depth
    double shear_ = 0;
    std::vector<glm::dvec2> points_;  ///< in radii
    std::vector<const surface*> blockers_;
};

}  // namespace joints
