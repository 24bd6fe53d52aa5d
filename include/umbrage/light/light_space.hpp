// SPDX-License-Identifier: MIT
//
// A light's view of the world: two matrices and the convention they follow.
//
//     auto light = umbrage::make_spot_light({.position = {0, 5, 0}, .direction = {0, -1, 0}});
//     glm::mat4 clip_from_world = light.projection * light.view;
//
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/scalar.hpp>

namespace umbrage {

template <real T>
struct light_space {
    glm::mat<4, 4, T> view{T(1)};        ///< world -> light's view space, a rotation; down -z (right) or +z (left)
    glm::mat<4, 4, T> projection{T(1)};  ///< view space -> clip space
    clip_space clip;
};

namespace detail {

/// Unit vector; scaled first, so that nothing overflows or underflows. Zero stays zero.
template <real T>
[[nodiscard]] glm::vec<3, T> unit(glm::vec<3, T> v) {
    const T scale = glm::max(glm::max(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
    return scale > T(0) ? glm::normalize(v / scale) : v;
}

}  // namespace detail

/// World to light's view space by a rotation: x to the right, y up.
///
/// @param position    of the light, world
/// @param direction   it looks along, any length > 0
/// @param up          hint; where it is parallel to direction, or nearly (1e-3), the world axis least along direction
///                    takes its place, so that any direction works
/// @param hand        of world and view; right: looks down -z, as glm::lookAtRH, left: down +z, as glm::lookAtLH
/// @throws std::invalid_argument  zero or non-finite direction or position
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand) {
    for (int i = 0; i < 3; ++i)
        if (!is_finite(position[i]) || !is_finite(direction[i]) || !is_finite(up[i]))
            detail::fail("umbrage: a light's position, direction and up must be finite");
    const glm::vec<3, T> forward = detail::unit(direction);
    if (forward == glm::vec<3, T>(0)) detail::fail("umbrage: a light's direction must not be zero");

    glm::vec<3, T> side = glm::cross(forward, detail::unit(up));
    if (!(glm::length(side) > T(1e-3))) {
        const glm::vec<3, T> along = glm::abs(forward);
        const int least = along.x <= along.y && along.x <= along.z ? 0 : (along.z <= along.y ? 2 : 1);
        glm::vec<3, T> axis(0);
        axis[least] = T(1);
        side = glm::cross(forward, axis);
    }
    const glm::vec<3, T> above = glm::normalize(glm::cross(side, forward));
    side = glm::cross(forward, above);  // again: up nearly parallel to forward leaves the first a hundred ulp askew
    const T towards = hand == handedness::right ? T(1) : T(-1);  // left: half a turn about y

    glm::mat<4, 4, T> view(T(1));
    for (int i = 0; i < 3; ++i) {
        view[i][0] = towards * side[i];
        view[i][1] = above[i];
        view[i][2] = -towards * forward[i];
    }
    view[3][0] = -towards * glm::dot(side, position);
    view[3][1] = -glm::dot(above, position);
    view[3][2] = towards * glm::dot(forward, position);
    return view;
}

namespace detail {

/// Rows that send view-space distance z_near to the near depth and z_far to the far depth of the convention.
template <real T>
struct depth_ends {
    T at_near, at_far;
};
template <real T>
[[nodiscard]] constexpr depth_ends<T> ends(clip_space clip) {
    const T low = clip.range == depth_range::zero_to_one ? T(0) : T(-1);
    return clip.direction == depth_direction::forward ? depth_ends<T>{low, T(1)} : depth_ends<T>{T(1), low};
}

template <real T>
void check_planes(T z_near, T z_far) {
    if (!is_finite(z_near) || !is_finite(z_far) || !(z_near < z_far))
        detail::fail("umbrage: a light needs finite z_near < z_far");
}

}  // namespace detail

/// Perspective projection.
///
/// @param tan_half_x, tan_half_y   tangent of half the opening angle, > 0
/// @param z_near, z_far            0 < z_near < z_far, world units
/// @throws std::invalid_argument   anything else
/// @formula       z/w = A + B / distance through (z_near, near depth), (z_far, far depth)
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip) {
    detail::check_planes(z_near, z_far);
    if (!(z_near > T(0))) detail::fail("umbrage: a perspective light needs z_near > 0");
    if (!is_finite(tan_half_x) || !is_finite(tan_half_y) || !(tan_half_x > T(0)) || !(tan_half_y > T(0)))
        detail::fail("umbrage: a perspective light needs an opening angle above 0 and below 180 degrees");
    const auto [at_near, at_far] = detail::ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(0));
    m[0][0] = T(1) / tan_half_x;
    m[1][1] = T(1) / tan_half_y;
    m[2][2] = forward * (z_far * at_far - z_near * at_near) / (z_far - z_near);
    m[3][2] = z_near * z_far * (at_near - at_far) / (z_far - z_near);
    m[2][3] = forward;
    return m;
}

/// Orthographic projection of the box between two corners of view space, z given as distances in front of the light.
///
/// @param low, high        x and y of the corners, low < high
/// @param z_near, z_far    z_near < z_far, world units, may be negative (behind the light's position)
/// @throws std::invalid_argument   an empty or non-finite box
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip) {
    detail::check_planes(z_near, z_far);
    for (int i = 0; i < 2; ++i)
        if (!is_finite(low[i]) || !is_finite(high[i]) || !(low[i] < high[i]))
            detail::fail("umbrage: an orthographic light needs a box with some width and height");
    const auto [at_near, at_far] = detail::ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(1));
    for (int i = 0; i < 2; ++i) {
        m[i][i] = T(2) / (high[i] - low[i]);
        m[3][i] = -(high[i] + low[i]) / (high[i] - low[i]);
    }
    m[2][2] = forward * (at_far - at_near) / (z_far - z_near);
    m[3][2] = (z_far * at_near - z_near * at_far) / (z_far - z_near);
    return m;
}

}  // namespace umbrage
