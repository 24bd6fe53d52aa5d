// SPDX-License-Identifier: MIT
//
// Directional light fitted to its receivers, with the near plane pulled back to include their casters.
//
//     auto light = umbrage::fit_directional_light<float>({.direction = d, .receivers = scene, .clip = clip});
//     auto tight = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::intersection(camera, scene), .casters = scene, .clip = clip});
//     auto still = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::sphere_around(camera), .casters = scene, .snap_texels = {1024, 1024},
//          .clip = clip});
//
// Also called: light frustum fitting (fit_directional_light); texel snapping of one map (snap_texels).
// See also: cascades/cascades.hpp for several maps, spot_fit.hpp.
#pragma once

#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {

/// Receivers and casters that a map of a directional light is fitted to.
template <real T = float>
struct directional_fit {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< direction the light travels; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint for the map's up axis; may be parallel to direction
    std::optional<hull> receivers{};              ///< required: a box, sphere, frustum, polyhedron or points
    std::optional<bounding_box<T>> casters{};     ///< if missing: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);         ///< border on every side, as a fraction of the receivers' diameter, >= 0
    glm::ivec2 snap_texels{0};  ///< map size that keeps texels fixed in the world; 0: no snapping
    clip_space clip{};          ///< required: clip space of your API or engine, see clip_space.hpp
};

namespace detail {

/// Box in front of a light. Its center is a fraction of its half sides, so that these keep their bits at any place.
struct light_box {
    glm::dvec2 half, middle;
    double z_near, z_far;
};

/// Box around a box: one texel wider, of square texels on a fixed grid. Its depths go in steps of its longer side.
[[nodiscard]] inline light_box snapped(const light_box& box, glm::ivec2 texels) {
    const glm::dvec2 n(texels), halves = box.half / (n - 1.0);
    const double half_texel = (glm::max)(halves.x, halves.y), side = 2.0 * half_texel * (glm::max)(n.x, n.y);
    const glm::dvec2 first = glm::round((box.middle * box.half / half_texel - n) * 0.5);
    const double z_near = std::floor(box.z_near / side) * side;
    return {half_texel * n, first * (2.0 / n) + 1.0, z_near,
            z_near + (std::ceil((box.z_far - box.z_near) / side) + 1.0) * side};
}

/// Body of fit_directional_light. Errors name `function`, and the arguments that give the box's sides and depths.
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

    light_space<T> space{.view = look_along(glm::vec<3, T>(T(0)), fit.direction, fit.up, fit.clip.hand, function, ""),
                         .clip = fit.clip,
                         .parallel = true};
    const glm::dmat4 frame = light_frame(space.view, fit.clip.hand);
    const hull box_of_casters(fit.casters.value_or(bounding_box<T>{}));
    const hull& receivers = lit.points.empty() ? box_of_casters : lit;
    const auto points = seen(frame, receivers.points);
    const auto [low, high] = extent_of(points);
    const double radius = receivers.radius;
    const double margin = double(fit.margin) * (extent_of(receivers.points).diagonal() + 2.0 * radius),
                 around = radius + margin;
    const glm::dvec2 half = glm::dvec2(high - low) * 0.5 + around;
    light_box box{half, glm::dvec2(high + low) * 0.5 / half, low.z - around, high.z + around};
    if (fit.casters && snaps) {
        const auto casters = extent_of(seen(frame, hull(*fit.casters).points));
        box.z_near = (glm::min)(box.z_near, casters.low.z), box.z_far = (glm::max)(box.z_far, casters.high.z);
    } else if (fit.casters) {
        // of the whole map, also where no receiver is: contact hardening wants each caster of a map at its distance
        const auto swept = sweep({low, {low.x, high.y, low.z}, {high.x, low.y, low.z}, high}, around);
        box.z_near = (glm::min)(box.z_near, nearest(frame, *fit.casters, swept) - margin);
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

/// Light space of the smallest box along the light that holds the receivers and their casters, with the margin around.
///
/// Casters count if they lie in the volume that the map's rectangle sweeps towards the light. Other casters throw no
/// shadow on the receivers, so they do not move the near plane.
///
/// With snap_texels the box takes the map's aspect ratio, so that texels are square, and grows by one texel. Its texels
/// then lie on a grid fixed in the world while the receivers move. This holds as long as the receivers' extent keeps
/// its bits, as a sphere's does. The depths span the whole box of casters, in steps of the box's longer side.
/// To keep the grid stable to 1/100 texel far from the origin, fit in double and use texture_matrix with an origin.
///
/// @edge   receivers without points (a camera that sees nothing of a scene): a map of the casters' box. Without casters
///         too: of a box around the origin
/// @accuracy   2^19 half sizes of the map from the origin (2^48 in double) rounding moves receivers by up to 1/16 of a
///             half size, out of the map without a margin. Nearer to it this falls in proportion
/// @throws std::invalid_argument  zero or non-finite direction; receivers missing or without extent; an invalid box of
///                                casters; a negative margin; clip unset; matrices that would not be finite
/// @cite   Valient: Stable Rendering of Cascaded Shadow Maps, ShaderX6, 2008
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    return detail::fit_directional(fit, "fit_directional_light", "receivers and margin",
                                   "receivers, casters and margin");
}

}  // namespace umbrage
