// SPDX-License-Identifier: MIT
//
// What the fit of a draw says that its maps hold: a receiver of these that they lack is lit without a word.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/light/bounds.hpp>

#include "choices.hpp"
#include "scene.hpp"

namespace joints {

/// True for receivers that the maps of a draw must hold, by some rounding of their ends.
[[nodiscard]] inline std::function<bool(glm::dvec3)> promises_of(const choices& c, const scene& s) {
    using enum setup_kind;
    const double unit = c.scale, ulps = 0x1p-21 * glm::length(s.placed(glm::dvec3(0)));
    const glm::dvec3 lamp = s.placed(s.lamp), axis = glm::normalize(s.turned(s.aim));
    const auto in_box = [b = c.setup == warped_lamp ? s.low_box() : s.near_box(), o = s.origin](glm::dvec3 p) {
        return glm::all(glm::greaterThan(p + o, b.low)) && glm::all(glm::lessThan(p + o, b.high));
    };
    const auto in_cone = [=, nearest = 1.1 * s.z_near * unit + ulps, cosine = std::cos(0.97 * s.angle)](glm::dvec3 p) {
        const double along = glm::dot(axis, p - lamp);
        return along > nearest && along < 29 * unit && along > glm::length(p - lamp) * cosine;
    };
    if (c.setup == spot) return in_cone;
    if (c.setup == fitted_spot) return [=](glm::dvec3 p) { return in_cone(p) && in_box(p); };
    if (c.setup == sun_by_hand) return [](glm::dvec3) { return false; };  // a map of 12 units, wherever they are
    if (c.setup == pages)
        return [=, middle = s.placed(glm::dvec3(0))](glm::dvec3 p) { return glm::length(p - middle) < 9 * unit; };
    if (c.is_point())  // 3.2: a tetrahedron's near plane is three times as far at its corners
        return [=, nearest = 3.2 * s.z_near * unit + ulps](glm::dvec3 p) {
            const double away = glm::length(p - lamp);
            return away > nearest && away < 24 * unit;
        };
    if (!c.has_camera()) return in_box;
    const double off = 1e-5 * unit + 0x1p-22 * glm::length(s.placed(glm::dvec3(0)));  // of points on the ground
    const double spare = 1e-4 * unit + 8 * off + 0x1p-22 * glm::length(s.placed(glm::dvec3(0)) + s.origin);
    const auto on_ground = [=, up = s.turned({0, 1, 0}), at = s.placed(glm::dvec3(0))](glm::dvec3 p) {
        return std::abs(glm::dot(up, p - at)) < off;
    };
    return [=, seen = umbrage::polyhedron(s.camera<double>()), o = s.origin,
            needs_ground = c.warps_for_ground()](glm::dvec3 p) {
        return (needs_ground ? on_ground(p) : in_box(p)) && std::ranges::all_of(seen.faces(), [&](const auto& face) {
                   return glm::dot(face.plane, glm::dvec4(p + o, 1)) > spare;
               });
    };
}

}  // namespace joints
