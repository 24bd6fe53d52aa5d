// SPDX-License-Identifier: MIT
//
// World size of a light's texels, and its depth per world unit.
#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage::detail {

/// Edges of a texel's footprint across the light, along x and y, and depth per world unit along it, at w = 1.
/// @throws std::invalid_argument  map_size below 1; clip unset; a warped map; units that are not finite and above 0; in
///                                the name of `function`
template <real T>
[[nodiscard]] glm::vec<3, T> texel_units(const light_space<T>& light, glm::ivec2 map_size, const char* function) {
    require_given(light.clip, function, "light.clip");
    require(map_size.x >= 1 && map_size.y >= 1, function, "map_size", "above 0", map_size);
    const glm::mat<4, 4, T>& p = light.projection;
    require(p[0][3] == T(0) && p[1][3] == T(0), function, "light.projection",
            "free of a warp, its x and y without a part in w", p,
            "A warp's units differ from point to point: a shadow takes it, and light_units_at measures a point.");
    const bool perspective = p[2][3] != T(0);
    const T along = glm::abs(perspective ? p[3][2] : p[2][2]);
    const glm::vec<3, T> units(T(2) / (glm::abs(p[0][0]) * T(map_size.x)), T(2) / (glm::abs(p[1][1]) * T(map_size.y)),
                               light.clip.range == depth_range::minus_one_to_one ? along * T(0.5) : along);
    require(is_normal(units.x) && is_normal(units.y) && is_normal(units.z), function, "light and map_size",
            "such that units are finite and above 0", units);
    return units;
}

}  // namespace umbrage::detail
