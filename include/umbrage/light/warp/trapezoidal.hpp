// SPDX-License-Identifier: MIT
//
// Trapezoidal shadow maps: a directional light's map from the trapezoid around what the camera sees, which is warped so
// that up to a chosen distance the camera gets four fifths of the map.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     auto warped = umbrage::fit_trapezoidal(fit, 20.0f);
//
#pragma once

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// The map of a directional light, warped along the camera's view with the focus on what is close.
///
/// Under lights 6 to 14 degrees above a ground it can resolve far less than a map without a warp: see choose_light.
///
/// @param focus   distance along the camera's view up to which four fifths of the map are for, world units, >= 0;
///                receivers that begin behind it get the strongest warp there is; none where four fifths of the
///                receivers lie before it
/// @return        strength 0, which is no warp, for orthographic cameras and where the sine of the angle between view
///                and light is 0.02 or less; from there to 0.2 the warp grows, without a jump
/// @throws std::invalid_argument  zero or non-finite direction, a camera that is none, receivers of no extent,
///                                casters that are no box, a margin out of range, focus negative or not finite, and
///                                what gives matrices that are not finite
/// @formula       the trapezoid's top and base cross the light's image of the camera's axis at the receivers' ends,
///                l apart; with the focus f behind the top the legs meet 0.4 l f / (1.6 l - 2 f) before it
/// @cite          Martin, Tan: Anti-aliasing and Continuity with Trapezoidal Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] warped_light<T> fit_trapezoidal(const warp_fit<T>& fit, T focus) {
    constexpr auto function = "fit_trapezoidal";
    const warp_fit<T> whole = detail::completed(fit, function);
    const detail::along_view v = detail::make_along_view(whole, function);
    detail::require(is_finite(focus) && focus >= T(0), function, "focus", "finite, 0 or more", focus);
    const double f = detail::greater(v.camera_y + double(focus) * v.sine - v.first.y, 0.0),
                 rest = 1.6 * v.length - 2.0 * f;
    if (!(rest > 0.0)) return detail::unwarped(whole, function);
    return detail::warped_along(v, 0.4 * v.length * f / rest, whole, function);
}

}  // namespace umbrage
