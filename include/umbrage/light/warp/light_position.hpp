// SPDX-License-Identifier: MIT
//
// Position of a point light for warps. `warp_fit::direction` is the light's axis, and all receivers must lie along it.
//
//     auto warped = umbrage::fit_perspective(fit, {.position = p, .z_near = 0.05f});
//
#pragma once

#include <vector>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// Position of a point light or spot light whose map is warped.
template <real T = float>
struct light_position {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);  ///< the light's own size, > 0: casters closer to it along the axis may be left out
};

namespace detail {

/// View of a point light: its receivers, and the casters that may stand between them and the light. If the fit has no
/// casters, they may stand anywhere from z_near on: a depth pass clips those of a point light.
struct axis_view {
    glm::dmat4 frame;        ///< world to x, y and the distance along the axis
    double least, farthest;  ///< smallest and largest distance of receivers
    polyhedron casters;
};

template <real T>
[[nodiscard]] axis_view view_of(const light_position<T>& from, const warp_fit<T>& fit, const char* function) {
    const glm::dvec3 position(from.position), direction(fit.direction), up = up_of(fit, function);
    axis_view v;
    v.frame = light_frame(look_along(position, direction, up, fit.clip.hand, function, "from.position"), fit.clip.hand);
    const std::vector<glm::dvec3> receivers = seen(v.frame, corners_of(*fit.receivers));
    const auto [low, high] = extent_of(receivers);
    v.least = low.z, v.farthest = high.z;
    require(v.least > double(from.z_near) && is_finite(2.0 * v.farthest), function, "receivers",
            "farther from the light than from.z_near, at finite distances", glm::dvec2(v.least, v.farthest));
    double edge = 1.0;
    for (const glm::dvec3& p : receivers) edge = (glm::max)(edge, (glm::max)(glm::abs(p.x), glm::abs(p.y)) / p.z);
    require(edge <= 0x1p16, function, "receivers", "within a slope of 2^16 of the light's axis", edge);
    const frustum<double> all{position, direction, up, 16.0 * edge, 16.0 * edge, double(from.z_near), 2.0 * v.farthest};
    v.casters = fit.casters ? intersection(all, *fit.casters) : polyhedron(all);
    return v;
}

/// Fit with a fallback: without receivers it takes a frustum right in front of the light.
template <real T>
[[nodiscard]] warp_fit<T> completed(const warp_fit<T>& fit, const light_position<T>& from, const char* function) {
    require(is_normal(from.z_near) && from.z_near > T(0), function, "from.z_near", "above 0, finite and no denormal",
            from.z_near);
    if (!given(fit.receivers, function).points.empty()) return completed(fit, hull(), function);
    (void)look_along(from.position, fit.direction, glm::vec<3, T>(0), fit.clip.hand, function, "from.position");
    const auto closest = double(from.z_near);
    const frustum<double> ahead{.position = glm::dvec3(from.position),
                                .direction = glm::dvec3(fit.direction),
                                .z_near = 2.0 * closest,
                                .z_far = 4.0 * closest};
    require_frustum(ahead, function, "from");
    return completed(fit, ahead, function);
}

/// Map of the light's view along its axis without a warp: world to x, y, depth and w.
template <class = on_use>
[[nodiscard]] glm::dmat4 map_along(const axis_view& v) {
    glm::dmat4 inverse(1.0);  // depth and w from the distance
    inverse[2] = {0, 0, 0, 1};
    inverse[3] = {0, 0, -0.5 * (v.least + v.farthest), 0};
    return inverse * v.frame;
}

template <real T>
[[nodiscard]] warped_light<T> unwarped(const axis_view& v, const warp_fit<T>& fit, const char* function) {
    const auto light = refit(map_along(v), fit, v.casters, function);
    if (!light) refuse_size(fit, function);
    return *light;
}

}  // namespace detail
}  // namespace umbrage
