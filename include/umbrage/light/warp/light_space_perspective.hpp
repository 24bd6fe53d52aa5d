// SPDX-License-Identifier: MIT
//
// Light-space perspective: a directional light's map, warped by a perspective across the light, whose center lies some
// way before what the camera sees. What lies side by side towards the light stays so: rays are texels.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     auto warped = umbrage::fit_light_space_perspective(fit);
//     auto milder = umbrage::fit_light_space_perspective(fit, umbrage::optimal_distance(fit));
//
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
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {
namespace detail {

/// A camera's receivers as the light sees them, y along the camera's view.
struct along_view {
    glm::dmat4 frame;  ///< world to x, y and depth
    glm::dvec3 first;  ///< x of the camera, least y of the receivers, and the camera's depth or that of the receivers
                       ///< next to it: planes through the warp's zero of depth and its center need no bias, and those
                       ///< near to them little
    double length;     ///< from their least y to the greatest
    double camera_y;
    double closest;  ///< least distance of receivers along the camera's view, no less than its near plane
    double sine;     ///< of the angle between view and light; 0 for an orthographic camera
};

template <real T>
[[nodiscard]] along_view make_along_view(const warp_fit<T>& fit, const char* function) {
    along_view v;
    v.frame = light_frame(view_of(fit, function), fit.clip.hand);
    const glm::dvec3 eye(fit.camera.position), view = axes(fit.camera, function, "camera")[2];
    // what an orthographic camera sees afar is no smaller: no warp, as where both look one way
    v.sine = is_perspective(fit.camera) ? glm::length(glm::cross(view, unit(glm::dvec3(fit.direction)))) : 0.0;
    const std::vector<glm::dvec3> receivers = corners_of(*fit.receivers);
    const auto [low, high] = extent_of(seen(v.frame, receivers));
    const glm::dvec3 own(v.frame * glm::dvec4(eye, 1.0));
    v.first = {own.x, low.y, glm::clamp(own.z, low.z, high.z)};
    v.length = high.y - low.y;
    v.camera_y = own.y;
    v.closest = highest<double>;
    for (const glm::dvec3& p : receivers) v.closest = lesser(v.closest, glm::dot(p - eye, view));
    v.closest = greater(v.closest, double(fit.camera.z_near));
    return v;
}

/// The wider the angle between view and light, the more of a warp there is: none below 0.02, all of it from 0.2 on.
[[nodiscard]] inline double share_of_warp(double sine) { return glm::clamp((sine - 0.02) / 0.18, 0.0, 1.0); }

/// The strongest warp there is: float holds no more.
[[nodiscard]] inline double least_distance(const along_view& v) { return v.length * 0x1p-14; }

/// @return   infinite where camera and light look one way, and for receivers of no extent at the camera
[[nodiscard]] inline double optimal_distance(const along_view& v) {
    const double n = (v.closest + std::sqrt(v.closest * (v.closest + v.length * v.sine))) / v.sine;
    const double least = detail::greater(n, least_distance(v));
    return v.sine > 0.0 && least > 0.0 ? least : detail::highest<double>;
}

/// Near the best on a ground.
[[nodiscard]] inline double default_distance(const along_view& v) { return std::sqrt(v.closest * optimal_distance(v)); }

/// A perspective along y whose center lies n before the first receivers; in front of them it changes no length.
/// @return    world to x, y, depth and w
/// @formula   (x, y, z) / (1 + y / n) about `first`
template <class = on_use>
[[nodiscard]] glm::dmat4 map_along(const along_view& v, double n) {
    const double bend = share_of_warp(v.sine) / detail::greater(n, least_distance(v));
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

/// How far before the receivers the center of a light-space perspective has to lie so that the greatest error over the
/// camera's frustum is least: the mildest warp that is of use.
/// @return      world units along the camera's view, across the light, > 0; infinite where both look one way
/// @formula     (z0 + sqrt(z0 z1)) / sin t, z1 = z0 + d sin t: z0 the receivers' least distance along the camera's
///              view, d their extent along it across the light, t the angle between view and light
/// @throws std::invalid_argument  as fit_light_space_perspective does
/// @cite        Wimmer, Scherzer, Purgathofer: Light Space Perspective Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] T optimal_distance(const warp_fit<T>& fit) {
    constexpr auto function = "optimal_distance";
    return T(detail::optimal_distance(detail::make_along_view(detail::completed(fit, function), function)));
}

/// The map of a directional light, warped along the camera's view.
///
/// Under lights 6 to 14 degrees above a ground it can resolve far less than a map without a warp: see choose_light.
///
/// @param distance   n, from the warp's center to the receivers next to it, world units along the camera's view across
///                   the light, > 0, infinite for no warp; the smaller, the more texels go to what is close, down to
///                   2^-14 of the receivers' extent, which stands for what is less. By default
///                   sqrt(z0 optimal_distance), z0 the receivers' least distance along the camera's view: near the best
///                   on a ground, whose depth on the screen is foreshortened, if it is seen from there on; too small
///                   where nothing is for long: see seen_range
/// @return           strength 0, which is no warp, for orthographic cameras and where the sine of the angle between
///                   view and light is 0.02 or less; from there to 0.2 the warp grows, without a jump
/// @throws std::invalid_argument  zero or non-finite direction, a camera that is none, receivers of no extent,
///                                casters that are no box, a margin out of range, distance not above 0, and what gives
///                                matrices that are not finite
/// @formula          (x, y, depth) / (1 + y / n) about the camera's x and depth and the receivers' least y, y along the
///                   view; then around the receivers
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
