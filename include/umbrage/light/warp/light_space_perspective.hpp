// SPDX-License-Identifier: MIT
//
// Light-space perspective shadow maps (LiSPSM): a directional light's map, warped by a perspective across the light.
// The warp's center lies some distance in front of the visible scene. Each ray of light falls on one point of the map.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     auto warped = umbrage::fit_light_space_perspective(fit);
//     auto milder = umbrage::fit_light_space_perspective(fit, umbrage::optimal_distance(fit));
//
// Also called: LiSPSM, LSPSM, light space perspective shadow maps (fit_light_space_perspective).
// See also: trapezoidal.hpp, perspective.hpp, cascades/warped.hpp.
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {
namespace detail {

/// Receivers of a camera as the light sees them, with y along the camera's view.
struct along_view {
    glm::dmat4 frame;  ///< world to x, y and depth
    glm::dvec3 first;  ///< x of the camera, smallest y of the receivers, their depth nearest to the camera's depth.
                       ///< Planes through the warp's center at this depth need no bias. Planes near to them need
                       ///< little
    double length;     ///< extent of the receivers in y
    double camera_y;
    double closest;  ///< smallest distance of receivers along the camera's view, at least z_near
    double sine;     ///< sine of the angle between view and light; 0 for an orthographic camera
};

template <real T>
[[nodiscard]] along_view make_along_view(const warp_fit<T>& fit, const char* function) {
    along_view v;
    v.frame = light_frame(view_of(fit, function), fit.clip.hand);
    const glm::dvec3 eye(fit.camera.position), view = axes(fit.camera, function, "camera")[2];
    // an orthographic camera needs no warp, nor does a camera that looks along the light
    v.sine = is_perspective(fit.camera) ? glm::length(glm::cross(view, unit(glm::dvec3(fit.direction)))) : 0.0;
    const std::vector<glm::dvec3> receivers = corners_of(*fit.receivers);
    const auto [low, high] = extent_of(seen(v.frame, receivers));
    const glm::dvec3 own(v.frame * glm::dvec4(eye, 1.0));
    v.first = {own.x, low.y, glm::clamp(own.z, low.z, high.z)};
    v.length = high.y - low.y;
    v.camera_y = own.y;
    v.closest = highest<double>;
    for (const glm::dvec3& p : receivers) v.closest = (glm::min)(v.closest, glm::dot(p - eye, view));
    v.closest = (glm::max)(v.closest, double(fit.camera.z_near));
    return v;
}

/// Fraction of the warp to apply, by the sine between view and light: none below 0.02, all of it from 0.2 on.
[[nodiscard]] inline double share_of_warp(double sine) { return glm::clamp((sine - 0.02) / 0.18, 0.0, 1.0); }

/// Smallest distance of the warp's center, for the strongest warp that float can hold.
[[nodiscard]] inline double least_distance(const along_view& v) { return v.length * 0x1p-14; }

/// Distance of the mildest useful warp.
/// @return   infinite if camera and light point in one direction, and for receivers of no extent at the camera
[[nodiscard]] inline double optimal_distance(const along_view& v) {
    const double n = (v.closest + std::sqrt(v.closest * (v.closest + v.length * v.sine))) / v.sine;
    const double least = (glm::max)(n, least_distance(v));
    return v.sine > 0.0 && least > 0.0 ? least : detail::highest<double>;
}

/// Distance that is close to optimal on a ground.
[[nodiscard]] inline double default_distance(const along_view& v) { return std::sqrt(v.closest * optimal_distance(v)); }

/// Perspective along y, whose center lies n in front of the first receivers. At those it changes no length.
/// @return    matrix from the world to x, y, depth and w
/// @formula   (x, y, z) / (1 + y / n) about `first`
template <class = on_use>
[[nodiscard]] glm::dmat4 map_along(const along_view& v, double n) {
    const double bend = share_of_warp(v.sine) / (glm::max)(n, least_distance(v));
    if (!(bend > 0.0 && is_finite(bend))) return v.frame;
    glm::dmat4 warp(1.0);
    warp[3] = glm::dvec4(-v.first, 1.0 - bend * v.first.y);
    warp[1][3] = bend;
    return warp * v.frame;
}

template <real T>
[[nodiscard]] warped_light<T> warped_along(const along_view& v, double n, const warp_fit<T>& fit,
                                           const char* function) {
    const auto warped = refit(map_along(v, n), fit, function);
    return warped ? *warped : unwarped(fit, function);
}

}  // namespace detail

/// Distance from the receivers to the center of a light-space perspective that minimizes the largest error over the
/// camera's frustum. It gives the mildest useful warp.
/// @return      world units along the camera's view, across the light, > 0
/// @edge        camera and light point in one direction: infinite
/// @formula     (z0 + sqrt(z0 z1)) / sin t, z1 = z0 + d sin t, with t the angle between view and light. Along the
///              camera's view z0 is the smallest distance of receivers, and d is their extent across the light
/// @throws std::invalid_argument  as fit_light_space_perspective
/// @cite        Wimmer, Scherzer, Purgathofer: Light Space Perspective Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] T optimal_distance(const warp_fit<T>& fit) {
    constexpr auto function = "optimal_distance";
    return T(detail::optimal_distance(detail::make_along_view(detail::completed(fit, function), function)));
}

/// Map of a directional light, warped along the camera's view.
///
/// Under lights 6 to 14 degrees above a ground it can resolve far less than a map without a warp: see choose_light.
///
/// @param fit        camera, light, receivers and casters
/// @param distance   distance n from the warp's center to the nearest receivers, > 0, in world units along the
///                   camera's view
///                   across the light. Smaller values give more texels to close receivers. Infinity gives no warp.
///                   2^-14 of the receivers' extent replaces smaller values. The default is sqrt(z0 optimal_distance),
///                   with z0 the receivers' smallest distance along the camera's view. It is close to optimal on a
///                   ground that is visible from z0 on, since the screen foreshortens its depth. It is too small if
///                   nothing is visible for a long way: see seen_range
/// @return           warped light. Its strength is 0, without a warp, for orthographic cameras and for a sine of 0.02
///                   or less between view and light. Between sines of 0.02 and 0.2 the warp grows without a jump
/// @throws std::invalid_argument  zero or non-finite direction; an invalid camera; receivers missing or without extent;
///                                an invalid box of casters; a margin out of range; distance not above 0; clip unset;
///                                matrices that would not be finite, or not hold the receivers: see warp_fit.hpp
/// @formula          (x, y, depth) / (1 + y / n) about the camera's x and depth and the receivers' smallest y, with y
///                   along the view. The result is fitted to the receivers
/// @cite             Wimmer, Scherzer, Purgathofer: Light Space Perspective Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] warped_light<T> fit_light_space_perspective(const warp_fit<T>& fit,
                                                          std::optional<std::type_identity_t<T>> distance = {}) {
    constexpr auto function = "fit_light_space_perspective";
    const warp_fit<T> whole = detail::completed(fit, function);
    const detail::along_view v = detail::make_along_view(whole, function);
    if (distance) detail::require(*distance > T(0), function, "distance", "above 0", *distance);
    return detail::warped_along(v, distance ? double(*distance) : detail::default_distance(v), whole, function);
}

}  // namespace umbrage
