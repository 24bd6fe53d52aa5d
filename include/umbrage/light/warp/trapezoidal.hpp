// SPDX-License-Identifier: MIT
//
// Trapezoidal shadow maps (TSM): a directional light's map of the trapezoid around the visible scene.
// The warp gives four fifths of the map to receivers up to a chosen distance.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     auto warped = umbrage::fit_trapezoidal(fit, 20.0f);
//
// Also called: TSM, trapezoidal shadow maps. See also: light_space_perspective.hpp, which needs no focus distance.
#pragma once

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// Map of a directional light, warped along the camera's view with a focus on close receivers.
///
/// Under lights 6 to 14 degrees above a ground it can resolve far less than a map without a warp: see choose_light.
///
/// @param fit     camera, light, receivers and casters
/// @param focus   distance along the camera's view that gets four fifths of the map, world units, >= 0
/// @return        warped light. Its strength is 0, without a warp, for orthographic cameras and for a sine of 0.02 or
///                less between view and light. Between sines of 0.02 and 0.2 the warp grows without a jump
/// @edge          the focus counts as at least a quarter of its distance behind the first receivers, and as 1/256 of
///                their length. Four fifths of them within it: no warp
/// @throws std::invalid_argument  zero or non-finite direction; an invalid camera; receivers missing or without extent;
///                                an invalid box of casters; a margin out of range; focus negative or not finite; clip
///                                unset; matrices that would not be finite, or not hold the receivers: see
///                                warp_fit.hpp
/// @formula       the trapezoid's top and base cross the light's image of the camera's axis at the receivers' ends,
///                l apart. With the focus f behind the top, its legs meet 0.4 l f / (1.6 l - 2 f) in front of the top
/// @cite          Martin, Tan: Anti-aliasing and Continuity with Trapezoidal Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] warped_light<T> fit_trapezoidal(const warp_fit<T>& fit, T focus) {
    constexpr auto function = "fit_trapezoidal";
    const warp_fit<T> whole = detail::completed(fit, function);
    const detail::along_view v = detail::make_along_view(whole, function);
    detail::require(is_finite(focus) && focus >= T(0), function, "focus", "finite, 0 or more", focus);
    const double ahead = double(focus) * v.sine, least = (glm::max)(ahead / 4.0, v.length / 256.0),
                 f = (glm::max)(v.camera_y + ahead - v.first.y, least), rest = 1.6 * v.length - 2.0 * f;
    if (!(rest > 0.0)) return detail::unwarped(whole, function);
    return detail::warped_along(v, 0.4 * v.length * f / rest, whole, function);
}

}  // namespace umbrage
