// SPDX-License-Identifier: MIT
//
// A directional light fitted to what receives its shadows, with the near plane pulled towards what casts them.
//
//     auto light = umbrage::fit_directional_light<float>({.direction = d, .receivers = scene, .clip = clip});
//     auto tight = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::intersection(camera, scene), .casters = scene, .clip = clip});
//     auto still = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::sphere_around(camera), .casters = scene, .snap_texels = {1024, 1024},
//          .clip = clip});
//
#pragma once

#include <cmath>
#include <optional>

#include <umbrage/core/check.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {

template <real T = float>
struct directional_fit {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    std::optional<hull> receivers{};              ///< required: box, sphere, frustum, polyhedron or points
    std::optional<bounding_box<T>> casters{};     ///< none: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);                           ///< added on every side, as a share of the receivers' diameter, >= 0
    glm::ivec2 snap_texels{0};                    ///< size of a map whose texels stay where they are; 0: not snapped
    clip_space clip{};                            ///< required: your API's or engine's, see clip_space.hpp
};

namespace detail {

/// A box in front of a light: its middle as a share of half its sides, so that these keep their bits wherever it is.
struct light_box {
    glm::dvec2 half, middle;
    double z_near, z_far;
};

/// The map of whole square texels around a box, a texel wider, and depths in steps of its longer side.
[[nodiscard]] inline light_box snapped(const light_box& box, glm::ivec2 texels) {
    const glm::dvec2 n(texels), halves = box.half / (n - 1.0);
    const double half_texel = greater(halves.x, halves.y), side = 2.0 * half_texel * greater(n.x, n.y);
    const glm::dvec2 first = glm::round((box.middle * box.half / half_texel - n) * 0.5);
    const double z_near = std::floor(box.z_near / side) * side;
    return {half_texel * n, first * (2.0 / n) + 1.0, z_near,
            z_near + (std::ceil((box.z_far - box.z_near) / side) + 1.0) * side};
}

/// fit_directional_light in the name of another function, whose arguments give the box's sides and depths.
template <real T>
[[nodiscard]] light_space<T> fit_directional(const directional_fit<T>& fit, const char* function, const char* sides,
                                             const char* depths) {
    require_given(fit.clip, function);
    const hull& lit = given(fit.receivers, function);
    require(is_finite(fit.margin) && fit.margin >= T(0), function, "margin", "finite, 0 or more", fit.margin);
    const bool snaps = fit.snap_texels != glm::ivec2(0);
    require(!snaps || (fit.snap_texels.x > 1 && fit.snap_texels.y > 1), function, "snap_texels", "0 or above 1",
            fit.snap_texels);
    if (fit.casters) require_box(*fit.casters, function, "casters");

    light_space<T> space{
        look_along(glm::vec<3, T>(T(0)), fit.direction, fit.up, fit.clip.hand, function, ""), {}, fit.clip};
    const glm::dmat4 frame = light_frame(space.view, fit.clip.hand);
    const hull box_of_casters(fit.casters.value_or(bounding_box<T>{}));
    const hull& receivers = lit.points.empty() ? box_of_casters : lit;
    const auto points = seen(frame, receivers.points);
    const auto [low, high] = extent_of(points);
    const auto [first, last] = extent_of(receivers.points);
    const double radius = receivers.radius;
    const double margin = double(fit.margin) * (glm::length(last - first) + 2.0 * radius), around = radius + margin;
    const glm::dvec2 half = glm::dvec2(high - low) * 0.5 + around;
    light_box box{half, glm::dvec2(high + low) * 0.5 / half, low.z - around, high.z + around};
    if (fit.casters && snaps) {
        const auto casters = extent_of(seen(frame, hull(*fit.casters).points));
        box.z_near = detail::lesser(box.z_near, casters.low.z), box.z_far = detail::greater(box.z_far, casters.high.z);
    } else if (fit.casters) {
        const auto swept = sweep(points, around);
        box.z_near = detail::lesser(box.z_near, nearest(frame, *fit.casters, swept) - margin);
    }
    if (snaps) box = snapped(box, fit.snap_texels);

    glm::dmat4 projection = orthographic(-box.half, box.half, box.z_near, box.z_far, fit.clip, function, sides, depths);
    projection[3][0] = -box.middle.x, projection[3][1] = -box.middle.y;
    space.projection = glm::mat<4, 4, T>(projection);
    for (glm::length_t i = 0; i < 3; ++i)
        require(is_normal(space.projection[i][i]), function, i < 2 ? sides : depths,
                "such that the box's size is neither too large nor too small",
                glm::dvec3(2.0 * box.half, box.z_far - box.z_near));
    return checked(space, function, depths);
}

}  // namespace detail

/// The smallest box along the light that holds the receivers and what of the casters' box they sweep towards the light,
/// with the margin all around. Casters beside the receivers leave the near plane where it is, as they throw no shadow
/// there; for a sphere's sweep stands that of its square.
///
/// With snap_texels the box has the map's aspect, so that texels are squares of the world, and is a texel wider. Its
/// texels lie on a grid of the world wherever the receivers move, as long as their extent keeps its bits: a sphere's
/// does. Its depths then span the casters' whole box, and go beyond it in steps of the box's longer side. For a grid
/// that keeps its place to a hundredth of a texel far from the origin, fit in double and take the texture matrix of an
/// origin.
///
/// Without receivers, as a camera may see none of a scene, any map will do: it is that of the casters' box,
/// or of one around the origin.
///
/// @throws std::invalid_argument  zero or non-finite direction, receivers of no extent, casters that are no
///                                box, a negative margin, and what gives matrices that are not finite
/// @cite   Valient: Stable Rendering of Cascaded Shadow Maps, ShaderX6, 2008
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    return detail::fit_directional(fit, "fit_directional_light", "receivers and margin",
                                   "receivers, casters and margin");
}

}  // namespace umbrage
