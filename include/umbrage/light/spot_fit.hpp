// SPDX-License-Identifier: MIT
//
// Spot light fitted to the receivers in its cone, with the near plane pulled back to include their casters.
//
//     const std::optional<umbrage::light_space<float>> light = umbrage::fit_spot_light<float>(
//         {.position = p, .direction = d, .receivers = umbrage::intersection(camera, scene), .casters = scene,
//          .clip = clip});
//     if (light) draw_depths(*light);  // else the cone contains nothing that the camera sees
//
// See also: spot_light.hpp, which maps the whole cone.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {

/// Receivers and casters that the map of a spot light is fitted to.
template <real T = float>
struct spot_fit {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(-1), T(0)};        ///< direction the light travels; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};                ///< hint for the map's up axis; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6;  ///< from axis to edge of the cone, above 0, at most 1.5
    T z_near = T(0.1);                         ///< smallest distance of the near plane, > 0: the light's own size
    std::optional<hull> receivers{};           ///< required: a box, sphere, frustum, polyhedron or points
    std::optional<bounding_box<T>> casters{};  ///< if missing: the near plane stays at z_near, and no caster is lost
    T margin = T(0.01);         ///< border on every side, as a fraction of the map and of distances, 0 to 1/2
    bool has_far_plane = true;  ///< false: depth nears the far depth with distance
    clip_space clip{};          ///< required: clip space of your API or engine, see clip_space.hpp
};

namespace detail {

/// Part of a hull beyond a distance that a spot light sees, within the tangents of its sides.
/// Its points are (x / distance, y / distance, distance).
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> tangents(std::vector<glm::dvec3> seen, double edge, double closest) {
    for (const glm::dvec4& plane : {glm::dvec4(0, 0, 1, -closest), glm::dvec4(1, 0, edge, 0),
                                    glm::dvec4(-1, 0, edge, 0), glm::dvec4(0, 1, edge, 0), glm::dvec4(0, -1, edge, 0)})
        seen = clipped_hull(seen, plane);
    for (glm::dvec3& p : seen) p = {p.x / p.z, p.y / p.z, p.z};
    return seen;
}

/// Smallest distance from a spot light to a box of casters, within the volume that receivers sweep towards the light.
/// @param receivers  receivers as tangents
/// @param outwards   margin around them, tangents
/// @param closest    distance where the sweep ends
template <class = on_use>
[[nodiscard]] double nearest_to_spot(const glm::dmat4& frame, const polyhedron& casters,
                                     const std::vector<glm::dvec3>& receivers, double outwards, double closest) {
    std::vector<glm::dvec4> planes = sweep(receivers, outwards);
    for (glm::dvec4& plane : planes) plane = {plane.x, plane.y, plane.w, 0.0};  // through the light
    planes.emplace_back(0.0, 0.0, 1.0, -closest);
    // the end of the sweep may lie inside the casters, where it meets none of their faces
    const glm::dvec4 end =
        glm::inverse(frame) * glm::dvec4(receivers.front().x * closest, receivers.front().y * closest, closest, 1.0);
    bool within = true;
    for (const polyhedron::face& face : casters.faces()) within = within && glm::dot(face.plane, end) >= 0.0;
    return within ? closest : nearest(frame, casters, planes);
}

}  // namespace detail

/// Light space of the smallest part of the cone's square pyramid that holds the receivers and their casters, with the
/// margin around.
///
/// Casters count if they lie in the volume that the receivers sweep towards the light. The result stays within the
/// pyramid. Its near plane is at z_near or beyond. The light may stand inside the receivers and casters. A sphere
/// counts as its bounding box, and points count as their convex hull. If some points lie outside, the cost grows with
/// the square of their number: for a mesh pass its box.
/// @return      nothing if no receivers of some extent lie in the pyramid beyond z_near: the light then needs no map
/// @throws std::invalid_argument  zero or non-finite direction; angle out of range; receivers missing or not finite;
///                                an invalid box of casters; clip unset; matrices that would not be finite; a light so
///                                far from the receivers or the origin that T is too coarse for its map; a near plane
///                                below 56 2^-24 of the far plane's distance with forward depth
template <real T = float>
[[nodiscard]] std::optional<light_space<T>> fit_spot_light(const spot_fit<T>& fit) {
    constexpr auto function = "fit_spot_light";
    detail::require_given(fit.clip, function);
    const hull& lit = detail::given(fit.receivers, function);
    const T angle = fit.outer_angle_radians;
    detail::require_cone(angle, function);
    detail::require(detail::is_normal(fit.z_near) && fit.z_near > T(0), function, "z_near",
                    "above 0, finite and no denormal", fit.z_near);
    detail::require(fit.margin >= T(0) && fit.margin <= T(0.5), function, "margin", "from 0 to 1/2", fit.margin);
    if (fit.casters) detail::require_box(*fit.casters, function, "casters");
    light_space<T> space{
        detail::look_along(fit.position, fit.direction, fit.up, fit.clip.hand, function, "position"), {}, fit.clip};
    const glm::dmat4 frame = detail::light_frame(space.view, fit.clip.hand);
    const double edge = std::tan(double(angle)), closest = double(fit.z_near);

    const auto before = detail::seen(frame, detail::corners_of(lit));
    const detail::extent around = detail::extent_of(before);
    const glm::dvec3 size = (glm::max)(glm::abs(around.low), glm::abs(around.high));
    if (!(around.high.z > closest)) return {};
    detail::require(is_finite(4.0 * (size.x + size.y + (1.0 + edge) * size.z)), function, "receivers",
                    "near enough to the light for finite distances", size);
    const auto receivers = detail::tangents(before, edge, closest);
    if (receivers.empty()) return {};
    auto [low, high] = detail::extent_of(receivers);
    const double share = double(fit.margin), margin = share * (glm::max)(high.x - low.x, high.y - low.y);
    double z_near = closest;
    if (fit.casters)
        z_near = (glm::min)(low.z, detail::nearest_to_spot(frame, *fit.casters, receivers, margin, closest));
    z_near = (glm::max)(z_near * (1.0 - share), closest);
    const double z_far = fit.has_far_plane ? high.z * (1.0 + share) : detail::highest<double>;
    const glm::dvec2 first = (glm::max)(glm::dvec2(low) - margin, glm::dvec2(-edge)),
                     last = (glm::min)(glm::dvec2(high) + margin, glm::dvec2(edge));
    const glm::dvec2 half = (last - first) * 0.5;
    if (!(half.x > 0.0 && half.y > 0.0 && z_near < z_far)) return {};

    const double rounding =
        double(std::numeric_limits<T>::epsilon()) * (high.z + glm::length(glm::dvec3(fit.position)));
    detail::require((glm::max)(half.x, half.y) * high.z > 16.0 * rounding, function, "position",
                    "near enough to the receivers and the origin for its digits", fit.position);
    glm::dmat4 projection =
        detail::perspective(half.x, half.y, z_near, z_far, fit.clip, function, "z_near and receivers");
    if (fit.has_far_plane) detail::require_digits(z_near, z_far, fit.clip, function);
    for (glm::length_t i = 0; i < 2; ++i) projection[2][i] = -projection[2][3] * (first + last)[i] * 0.5 / half[i];
    space.projection = glm::mat<4, 4, T>(projection);
    for (glm::length_t i = 0; i < 2; ++i)
        detail::require(detail::is_normal(space.projection[i][i]), function, "receivers and margin",
                        "such that the map's size is neither too large nor too small", half);
    detail::require(detail::is_normal(space.projection[3][2]), function, "z_near and receivers",
                    "neither too far apart nor too close together", glm::dvec2(z_near, z_far));
    return detail::checked(space, function, "position, z_near and receivers");
}

}  // namespace umbrage
