// SPDX-License-Identifier: MIT
//
// Directional light set up by hand, as in the classic course exercise.
//
//     auto light = umbrage::make_directional_light({.direction = d, .map_size = {1024, 512}, .clip = clip});
//
// See also: directional_fit.hpp, which fits the map to receivers and casters.
#pragma once

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Directional light with a map of a given place and size.
template <real T = float>
struct directional_light {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< direction the light travels; any length > 0
    glm::vec<3, T> target{T(0)};                  ///< world point at the center of the map
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint for the map's up axis; may be parallel to direction
    T offset = T(10);                             ///< distance from target back to the light, world units
    glm::ivec2 map_size{1024};                    ///< map size in texels, each >= 1
    T texels_per_unit = T(10);                    ///< texels per world unit across the light, > 0
    T z_near = T(0.1);                            ///< distance of the near plane from the light, world units
    T z_far = T(100);
    clip_space clip{};  ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Light space of the exercise: position = target - unit direction * offset, sides = map_size / texels_per_unit.
/// @throws std::invalid_argument  zero or non-finite direction; map_size or texels_per_unit not above 0; planes out of
///                                order; clip unset; matrices that would not be finite
template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& light) {
    constexpr auto function = "make_directional_light";
    detail::require(light.map_size.x >= 1 && light.map_size.y >= 1, function, "map_size", "above 0", light.map_size);
    detail::require(is_finite(light.texels_per_unit) && light.texels_per_unit > T(0), function, "texels_per_unit",
                    "finite and above 0", light.texels_per_unit);
    detail::require(is_finite(light.offset), function, "offset", "finite", light.offset);
    // a view from the target, then moved back by the offset: the view's last row holds the light's distance
    light_space<T> space{
        .view = detail::look_along(light.target, light.direction, light.up, light.clip.hand, function, "target"),
        .clip = light.clip,
        .parallel = true};
    space.view[3][2] += light.clip.hand == handedness::right ? -light.offset : light.offset;
    const glm::vec<2, T> half(glm::vec<2, T>(light.map_size) / light.texels_per_unit / T(2));
    space.projection = detail::orthographic(-half, half, light.z_near, light.z_far, light.clip, function,
                                            "map_size and texels_per_unit", "z_near and z_far");
    return detail::checked(space, function, "target, offset, texels_per_unit, z_near and z_far");
}

}  // namespace umbrage
