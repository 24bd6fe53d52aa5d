// SPDX-License-Identifier: MIT
//
// A directional light's space: the classic course exercise's set-up, and the tight fit to bounds.
//
//     auto light = umbrage::make_directional_light({.direction = d, .map_size = 1024});
//     auto tight = umbrage::fit_directional_light({.direction = d, .low = scene_low, .high = scene_high});
//
#pragma once

#include <array>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/light/light_space.hpp>

namespace umbrage {

template <real T = float>
struct directional_light {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> target{T(0)};                  ///< what it looks at
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    T offset = T(10);                             ///< from target back to the light, world units
    int map_size = 1024;                          ///< texels, >= 1
    T texels_per_unit = T(10);                    ///< texels per world unit, > 0
    T z_near = T(0.1);                            ///< world units from the light
    T z_far = T(100);
    clip_space clip{};
};

/// The exercise's set-up: position = target - unit direction * offset, width = height = map_size / texels_per_unit.
/// @throws std::invalid_argument  zero or non-finite direction, map_size or texels_per_unit not above 0, planes out of
///                                order
template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& light) {
    if (light.map_size < 1 || !is_finite(light.texels_per_unit) || !(light.texels_per_unit > T(0)))
        detail::fail("umbrage::make_directional_light: map_size and texels_per_unit must be above 0");
    // along the normalised direction, moved by the offset: the view's last row holds the light's distance
    light_space<T> space{look_along(light.target, light.direction, light.up, light.clip.hand), {}, light.clip};
    space.view[3][2] += light.clip.hand == handedness::right ? -light.offset : light.offset;
    if (!is_finite(space.view[3][2])) detail::fail("umbrage::make_directional_light: offset must be finite");
    const T half = T(light.map_size) / light.texels_per_unit / T(2);
    space.projection = orthographic(glm::vec<2, T>(-half), glm::vec<2, T>(half), light.z_near, light.z_far, light.clip);
    return space;
}

template <real T = float>
struct directional_fit {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    glm::vec<3, T> low{T(-1)}, high{T(1)};        ///< bounds of all casters and receivers, low <= high
    T margin = T(0.01);                           ///< added on every side, as a share of the bounds' diagonal, > 0
    clip_space clip{};
};

/// The smallest box along the light that holds the bounds, and the margin.
/// @throws std::invalid_argument  zero or non-finite direction, bounds empty, inverted or of no extent
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    const T diagonal = glm::length(fit.high - fit.low);
    if (!is_finite(diagonal) || !(diagonal > T(0)) || glm::any(glm::greaterThan(fit.low, fit.high)))
        detail::fail("umbrage::fit_directional_light: bounds must be finite, in order, of some extent");
    if (!is_finite(fit.margin) || !(fit.margin > T(0)))
        detail::fail("umbrage::fit_directional_light: margin must be above 0");
    light_space<T> space{look_along((fit.low + fit.high) * T(0.5), fit.direction, fit.up, fit.clip.hand), {}, fit.clip};
    // the box is centred on the bounds' centre, so it is enough to know how far it reaches
    const glm::vec<3, T> half = (fit.high - fit.low) * T(0.5);
    glm::vec<3, T> reach(fit.margin * diagonal);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) reach[row] += glm::abs(space.view[i][row]) * half[i];
    space.projection =
        orthographic(glm::vec<2, T>(-reach.x, -reach.y), glm::vec<2, T>(reach.x, reach.y), -reach.z, reach.z, fit.clip);
    return space;
}

}  // namespace umbrage
