// SPDX-License-Identifier: MIT
//
// Every kind of light and fit that is held against rays.
#pragma once

#include <array>
#include <cstdint>

#include <umbrage/draw/rasterize.hpp>

namespace proof {

/// Points around which a light is set up, and its setup. Without casters of its own it clamps them to its near plane.
struct light_kind {
    enum class fitted_to { cone, box, points, frustum, sphere, cascade, light_space, trapezoid, perspective, ground };
    const char* name;
    bool is_spot;
    fitted_to receivers;
    umbrage::near_plane at_near = umbrage::near_plane::clips;
    bool has_far_plane = true;

    [[nodiscard]] constexpr bool sees_camera_only() const { return receivers >= fitted_to::frustum; }
};
inline constexpr std::array light_kinds{
    light_kind{"directional: box", false, light_kind::fitted_to::box},
    light_kind{"directional: points", false, light_kind::fitted_to::points},
    light_kind{"directional: frustum, casters apart", false, light_kind::fitted_to::frustum},
    light_kind{"directional: sphere, snapped", false, light_kind::fitted_to::sphere},
    light_kind{"directional: depth clamp", false, light_kind::fitted_to::frustum, umbrage::near_plane::clamps},
    light_kind{"directional: light-space perspective", false, light_kind::fitted_to::light_space},
    light_kind{"directional: trapezoidal", false, light_kind::fitted_to::trapezoid},
    light_kind{"directional: trapezoidal, depth clamp", false, light_kind::fitted_to::trapezoid,
               umbrage::near_plane::clamps},
    light_kind{"directional: perspective", false, light_kind::fitted_to::perspective},
    light_kind{"directional: plane-optimal", false, light_kind::fitted_to::ground},
    light_kind{"spot: perspective", true, light_kind::fitted_to::perspective},
    light_kind{"spot: cone", true, light_kind::fitted_to::cone},
    light_kind{"spot: receivers, casters apart", true, light_kind::fitted_to::frustum},
    light_kind{"spot: depth clamp", true, light_kind::fitted_to::frustum, umbrage::near_plane::clamps},
    light_kind{"spot: no far plane", true, light_kind::fitted_to::frustum, umbrage::near_plane::clips, false},
    light_kind{"directional: warped cascades", false, light_kind::fitted_to::cascade}};
inline constexpr std::uint64_t clip_space_count = 16, setting_count = light_kinds.size() * clip_space_count;

}  // namespace proof
