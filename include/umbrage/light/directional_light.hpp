// SPDX-License-Identifier: MIT
//
// A directional light's space: the classic course exercise's set-up, and the tight fit to bounds.
//
//     auto light = umbrage::make_directional_light({.direction = d, .map_size = 1024});
//     auto tight = umbrage::fit_directional_light({.direction = d, .low = scene_low, .high = scene_high});
//
#pragma once

#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/light/light_space.hpp>

namespace umbrage {

namespace detail {

/// Length, with the bits of glm::length but where a square overflows or vanishes.
template <real T>
[[nodiscard]] T length(glm::vec<3, T> v) {
    const T greatest = glm::max(glm::max(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
    if (!(greatest > T(0))) return T(0);
    const int scale = std::ilogb(greatest);
    return std::scalbn(
        glm::length(glm::vec<3, T>(std::scalbn(v.x, -scale), std::scalbn(v.y, -scale), std::scalbn(v.z, -scale))),
        scale);
}

}  // namespace detail

template <real T = float>
struct directional_light {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> target{T(0)};                  ///< what it looks at
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    T offset = T(10);                             ///< from target back to the light, world units
    int map_size = 1024;                          ///< texels, >= 1
    T texels_per_unit = T(10);                    ///< across the light, world units; > 0
    T z_near = T(0.1);                            ///< world units from the light
    T z_far = T(100);
    clip_space clip{};
};

/// The exercise's set-up: position = target - unit direction * offset, width = height = map_size / texels_per_unit.
/// @throws std::invalid_argument  zero or non-finite direction, map_size or texels_per_unit not above 0, planes out of
///                                order, and what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& light) {
    constexpr auto function = "make_directional_light";
    detail::require(light.map_size >= 1, function, "map_size", "must be above 0");
    detail::require(is_finite(light.texels_per_unit) && light.texels_per_unit > T(0), function, "texels_per_unit",
                    "must be finite and above 0");
    detail::require(is_finite(light.offset), function, "offset", "must be finite");
    // along the normalised direction, moved by the offset: the view's last row holds the light's distance
    light_space<T> space{
        detail::look_along(light.target, light.direction, light.up, light.clip.hand, function, "target"),
        {},
        light.clip};
    space.view[3][2] += light.clip.hand == handedness::right ? -light.offset : light.offset;
    const glm::vec<2, T> half(T(light.map_size) / light.texels_per_unit / T(2));
    space.projection = detail::orthographic(-half, half, light.z_near, light.z_far, light.clip, function,
                                            "map_size and texels_per_unit", "z_near and z_far");
    return detail::checked(space, function, "target, offset, texels_per_unit, z_near and z_far");
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
/// @throws std::invalid_argument  zero or non-finite direction, bounds empty, inverted or of no extent, and what gives
///                                matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    constexpr auto function = "fit_directional_light", bounds = "low and high", box = "low, high and margin";
    detail::require(detail::all_finite(fit.low) && detail::all_finite(fit.high), function, bounds, "must be finite");
    detail::require(!glm::any(glm::greaterThan(fit.low, fit.high)), function, "low", "must not be above high");
    detail::require(is_finite(fit.margin) && fit.margin > T(0), function, "margin", "must be finite and above 0");
    // halved first: the bounds may reach from one end of the numbers to the other
    const glm::vec<3, T> half = fit.high * T(0.5) - fit.low * T(0.5), centre = fit.low * T(0.5) + fit.high * T(0.5);
    const T radius = detail::length(half);
    detail::require(radius > T(0), function, bounds, "must have some extent");
    light_space<T> space{
        detail::look_along(centre, fit.direction, fit.up, fit.clip.hand, function, bounds), {}, fit.clip};
    // the box is centred on the bounds' centre, so it is enough to know how far it reaches
    glm::vec<3, T> reach(fit.margin * T(2) * radius);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) reach[row] += glm::abs(space.view[i][row]) * half[i];
    const glm::vec<2, T> side(reach);
    space.projection = detail::orthographic(-side, side, -reach.z, reach.z, fit.clip, function, box, box);
    return detail::checked(space, function, box);
}

}  // namespace umbrage
