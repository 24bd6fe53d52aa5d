// SPDX-License-Identifier: MIT
//
// Arguments of discs that lie between texels.
#pragma once

#include <umbrage/filter/pcf/disc.hpp>

#include "../entries.hpp"

namespace parity {

/// A radius of the receiver's x0.w, for C++ and for GLSL, from below zero to beyond the widest; and its rotation.
[[nodiscard]] inline float turned_radius(const sample& s) { return s.x[0].w * s.x[0].w * s.x[0].w * 0.375f; }
[[nodiscard]] inline vec4 turned_by(const sample& s) { return umbrage::disc_rotation(at(s)); }
inline constexpr auto turned_arguments = ", x0.w * x0.w * x0.w * 0.375, umbrage_disc_rotation(vec2(x0.x, x0.y))";

/// The same of an ellipse.
[[nodiscard]] inline vec2 turned_radii(const sample& s) { return {turned_radius(s), s.x[0].w * 0.75f}; }
inline constexpr auto turned_ellipse =
    ", vec2(x0.w * x0.w * x0.w * 0.375, x0.w * 0.75), umbrage_disc_rotation(vec2(x0.x, x0.y))";

}  // namespace parity
