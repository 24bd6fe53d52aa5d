// SPDX-License-Identifier: MIT
//
// Spot light: view and perspective projection around its whole cone.
//
//     auto light = umbrage::make_spot_light(
//         {.position = p, .direction = d, .outer_angle_radians = 0.6f, .clip = umbrage::opengl_clip_space});
//
// Also called: spotlight, cone light.
// See also: spot_fit.hpp, which fits the map to the receivers; point/point_light.hpp for light in all directions.
#pragma once

#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Spot light with a map over its whole cone.
template <real T = float>
struct spot_light {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(-1), T(0)};        ///< direction the light travels; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};                ///< hint for the map's up axis; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6;  ///< from axis to edge of the cone, above 0, at most 1.5
    T aspect = T(1);                                    ///< width / height of the map, > 0: makes texels square
    T z_near = T(0.1);                                  ///< near plane, world units, > 0. With forward depth at
                                                        ///< least 56 2^-24 z_far (3.4e-6)
    T z_far = T(100);                                   ///< distance of the far plane, > z_near; infinite: no far plane
    clip_space clip{};  ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Light space of a spot light. The map holds the whole cone, which touches the map's shorter sides.
/// @throws std::invalid_argument  zero or non-finite direction; angle out of range; aspect not above 0; planes out
///                                of order, or z_near below 56 2^-24 z_far with forward depth; clip unset; matrices
///                                that would not be finite
template <real T = float>
[[nodiscard]] light_space<T> make_spot_light(const spot_light<T>& light) {
    constexpr auto function = "make_spot_light";
    const T angle = light.outer_angle_radians;
    detail::require_cone(angle, function);
    const T extent = static_cast<T>(std::tan(static_cast<double>(angle)));  // a float's depends on optimization
    detail::require(detail::is_normal(T(1) / extent), function, "outer_angle_radians",
                    "large enough for a finite cotangent", angle);
    detail::require(is_finite(light.aspect) && light.aspect > T(0), function, "aspect", "finite and above 0",
                    light.aspect);
    const T wide = extent * (glm::max)(light.aspect, T(1)), high = extent / (glm::min)(light.aspect, T(1));
    const bool fits = detail::is_normal(T(1) / wide) && detail::is_normal(T(1) / high);
    detail::require(fits, function, "aspect", "such that the tangents of the map's sides are finite", light.aspect);
    const light_space<T> space{
        detail::look_along(light.position, light.direction, light.up, light.clip.hand, function, "position"),
        detail::perspective(wide, high, light.z_near, light.z_far, light.clip, function), light.clip};
    detail::require_digits(light.z_near, light.z_far, light.clip, function);
    return detail::checked(space, function, "position, outer_angle_radians, z_near and z_far");
}

}  // namespace umbrage
