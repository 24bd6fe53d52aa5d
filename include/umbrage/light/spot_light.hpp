// SPDX-License-Identifier: MIT
//
// A spot light's space.
//
//     auto light = umbrage::make_spot_light(
//         {.position = p, .direction = d, .outer_angle_radians = 0.6f, .clip = umbrage::opengl_clip_space});
//
#pragma once

#include <cmath>
#include <numbers>

#include <umbrage/core/check.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

template <real T = float>
struct spot_light {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(-1), T(0)};        ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};                ///< hint; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6;  ///< between axis and edge of the cone, above 0, below pi / 2
    T aspect = T(1);                                    ///< width / height of the map, > 0: texels are square
    T z_near = T(0.1);                                  ///< > 0, world units
    T z_far = T(100);                                   ///< > z_near; infinite: no far plane
    clip_space clip{};                                  ///< required: your API's or engine's, see clip_space.hpp
};

/// View and perspective projection around the light's cone, which the map holds whole: it touches the shorter sides.
/// @throws std::invalid_argument  zero or non-finite direction, angle outside (0, pi / 2), aspect not above 0, planes
///                                out of order, and what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_spot_light(const spot_light<T>& light) {
    constexpr auto function = "make_spot_light";
    const T angle = light.outer_angle_radians;
    detail::require(is_finite(angle) && angle > T(0) && angle < std::numbers::pi_v<T> / 2, function,
                    "outer_angle_radians", "above 0 and below pi / 2", angle, "Is it in degrees?");
    const T extent = std::tan(angle);
    detail::require(detail::is_normal(T(1) / extent), function, "outer_angle_radians",
                    "large enough for a finite cotangent", angle);
    detail::require(is_finite(light.aspect) && light.aspect > T(0), function, "aspect", "finite and above 0",
                    light.aspect);
    const T wide = extent * detail::greater(light.aspect, T(1)), high = extent / detail::lesser(light.aspect, T(1));
    const bool fits = detail::is_normal(T(1) / wide) && detail::is_normal(T(1) / high);
    detail::require(fits, function, "aspect", "such that the tangents of the map's sides are finite", light.aspect);
    return detail::checked<T>(
        {detail::look_along(light.position, light.direction, light.up, light.clip.hand, function, "position"),
         detail::perspective(wide, high, light.z_near, light.z_far, light.clip, function), light.clip},
        function, "position, outer_angle_radians, z_near and z_far");
}

}  // namespace umbrage
