// SPDX-License-Identifier: MIT
//
// Light space: a light's view and projection matrices, and the clip space they follow. Every setup function returns
// finite matrices with a finite product, or reports the argument at fault.
//
//     auto light = umbrage::make_spot_light(
//         {.position = {0, 5, 0}, .direction = {0, -1, 0}, .clip = umbrage::opengl_clip_space});
//     glm::mat4 clip_from_world = light.projection * light.view;
//
// Also called: light view-projection, lightSpaceMatrix, light camera (light_space).
//
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>

namespace umbrage {

/// Matrices of a light, and the clip space that they lead to.
template <real T>
struct light_space {
    glm::mat<4, 4, T> view{T(1)};  ///< world to view space, without a mirror; looks down -z (right-handed) or +z (left)
    glm::mat<4, 4, T> projection{T(1)};  ///< view space to clip space
    clip_space clip;
    bool parallel = false;  ///< true promises a projection without perspective: the shadow then costs less in a shader
};

namespace detail {

/// True if a value neither overflowed nor is a denormal, which some modes flush to zero.
template <real T>
[[nodiscard]] bool is_normal(T v) {
    return is_finite(v) && glm::abs(v) >= (std::numeric_limits<T>::min)();
}

/// Final check of a light's matrices, shared by all setup functions.
template <real T>
[[nodiscard]] light_space<T> checked(const light_space<T>& light, const char* function, const char* arguments) {
    const glm::mat<4, 4, T> m = light.projection * light.view;
    const bool finite = all_finite(light.view) && all_finite(light.projection) && all_finite(m);
    require(finite, function, arguments, "such that the matrix is finite", m,
            std::is_same_v<T, float> ? "Numbers this large need the double version." : "");
    return light;
}

/// Unit vector. It is scaled first, so that nothing overflows or underflows. Zero stays zero.
template <real T>
[[nodiscard]] glm::vec<3, T> unit(glm::vec<3, T> v) {
    const T scale = (glm::max)((glm::max)(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
    return scale > T(0) ? glm::normalize(v / scale) : v;
}

/// Two unit vectors at right angles to a unit vector, and to each other.
template <real T>
[[nodiscard]] std::array<glm::vec<3, T>, 2> across(glm::vec<3, T> v) {
    const glm::vec<3, T> size = glm::abs(v);
    const glm::length_t least = size.x <= size.y && size.x <= size.z ? 0 : (size.z <= size.y ? 2 : 1);
    glm::vec<3, T> axis(0);
    axis[least] = T(1);
    const glm::vec<3, T> side = glm::normalize(glm::cross(v, axis));
    return {side, glm::cross(v, side)};
}

/// Body of look_along. Errors name `function` and the argument of the position. The caller checks the result.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand, const char* function, const char* position_name) {
    require(all_finite(position), function, position_name, "finite", position);
    require(all_finite(direction), function, "direction", "finite", direction);
    require(all_finite(up), function, "up", "finite", up);
    const glm::vec<3, T> forward = unit(direction);
    require(forward != glm::vec<3, T>(0), function, "direction", "of a length above 0", direction);

    glm::vec<3, T> side = glm::cross(forward, unit(up));
    if (!(glm::length(side) > T(1e-3))) side = across(forward)[0];
    const glm::vec<3, T> above = glm::normalize(glm::cross(side, forward));
    side = glm::cross(forward, above);  // again: with up nearly parallel to forward the first is a hundred ulp off
    const T towards = hand == handedness::right ? T(1) : T(-1);  // left: half a rotation about y

    glm::mat<4, 4, T> view(T(1));
    for (glm::length_t i = 0; i < 3; ++i) {
        view[i][0] = towards * side[i];
        view[i][1] = above[i];
        view[i][2] = -towards * forward[i];
    }
    view[3][0] = -towards * glm::dot(side, position);
    view[3][1] = -glm::dot(above, position);
    view[3][2] = towards * glm::dot(forward, position);
    return view;
}

}  // namespace detail

/// View matrix from the world to the light's view space, where x points right and y up. It never mirrors.
///
/// @param position    position of the light, world
/// @param direction   direction the light looks, any length > 0
/// @param up          hint for the up axis. The world axis with the smallest component along direction replaces it
///                    if it is parallel to direction (within 1e-3). So any direction works
/// @param hand        handedness of the world and the view. right: looks down -z as glm::lookAtRH, left: looks down +z
///                    as glm::lookAtLH
/// @throws std::invalid_argument  zero or non-finite direction; non-finite position
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand) {
    const auto view = detail::look_along(position, direction, up, hand, "look_along", "position");
    detail::require(detail::all_finite(view), "look_along", "position", "nearer to the origin", position);
    return view;
}

namespace detail {

/// Depths of the near and the far plane in a clip space.
template <real T>
struct depth_ends {
    T at_near, at_far;
};
template <real T>
[[nodiscard]] constexpr depth_ends<T> ends(clip_space clip) {
    const T low = clip.range == depth_range::zero_to_one ? T(0) : T(-1);
    return clip.direction == depth_direction::forward ? depth_ends<T>{low, T(1)} : depth_ends<T>{T(1), low};
}

/// Body of perspective. Errors name `function`, and `planes` as the source of the planes. The caller checks tangents.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip,
                                            const char* function, const char* planes = "z_near and z_far") {
    require_given(clip, function);
    require(is_normal(z_near) && z_near > T(0), function, "z_near", "above 0, finite and no denormal", z_near);
    require(!is_nan(z_far) && z_near < z_far, function, "z_far", "above z_near", z_far);
    const auto [at_near, at_far] = ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    // scaled by powers of two, which keep the bits and prevent overflow; without a far plane z_near counts as 0
    const bool bounded = is_finite(z_far);
    const int far_scale = bounded ? std::ilogb(z_far) : 0, near_scale = std::ilogb(z_near);
    const T f = bounded ? std::scalbn(z_far, -far_scale) : T(1), n = bounded ? std::scalbn(z_near, -far_scale) : T(0);
    const T product = std::scalbn(z_near, -near_scale) * f * (at_near - at_far);
    glm::mat<4, 4, T> m(T(0));
    m[0][0] = T(1) / tan_half_x;
    m[1][1] = T(1) / tan_half_y;
    m[2][2] = forward * (f * at_far - n * at_near) / (f - n);
    m[3][2] = std::scalbn(product / (f - n), near_scale);
    m[2][3] = forward;
    require(is_finite(m[3][2]), function, planes, "farther apart, or nearer to 0", glm::vec<2, T>(z_near, z_far));
    return m;
}

/// Refuses a near plane so near that forward depth in float is too coarse at the far plane. There the smallest bias
/// that covers rounding, 7 units of 2^-24, would span an eighth of z_far or more. Reversed depth keeps its precision.
template <real T>
void require_digits(T z_near, T z_far, clip_space clip, const char* function) {
    const double limit = 56 * 0x1p-24 * double(z_far);
    if (clip.direction == depth_direction::reversed || !is_finite(z_far) || double(z_near) >= limit) return;
    refuse(function, "z_near", "at least " + printed(limit) + " (56 2^-24 z_far) with forward depth", z_near,
           "Take a larger z_near, or reversed depth.");
}

/// Refuses a spot light's angle that its map cannot hold. Beyond the widest one, texels on the axis are too wide.
template <real T>
void require_cone(T outer_angle_radians, const char* function) {
    constexpr T widest(1.5);
    require(outer_angle_radians > T(0) && outer_angle_radians <= widest, function, "outer_angle_radians",
            "above 0 and at most 1.5 (86 degrees)", outer_angle_radians,
            "Is it in degrees? For a wider light take a point_light.");
}

/// Body of orthographic. Errors name `function`, and the arguments that give the box and the planes.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip, const char* function, const char* box,
                                             const char* planes) {
    require_given(clip, function);
    require(all_finite(low) && all_finite(high), function, box, "a finite box", glm::vec<4, T>(low, high));
    require(low.x < high.x && low.y < high.y, function, box, "a box with some width and height",
            glm::vec<4, T>(low, high));
    require(is_finite(z_near) && is_finite(z_far), function, planes, "finite", glm::vec<2, T>(z_near, z_far));
    require(z_near < z_far, function, planes, "in order, some distance apart", glm::vec<2, T>(z_near, z_far));
    const auto [at_near, at_far] = ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(1));
    for (glm::length_t i = 0; i < 2; ++i) {
        m[i][i] = T(2) / (high[i] - low[i]);
        m[3][i] = -(high[i] + low[i]) / (high[i] - low[i]);
        require(is_normal(m[i][i]) && is_finite(m[3][i]), function, box, "neither too large nor too small a box",
                glm::vec<4, T>(low, high));
    }
    m[2][2] = forward * (at_far - at_near) / (z_far - z_near);
    m[3][2] = (z_far * at_near - z_near * at_far) / (z_far - z_near);
    require(is_normal(m[2][2]) && is_finite(m[3][2]), function, planes, "neither too far apart nor too close together",
            glm::vec<2, T>(z_near, z_far));
    return m;
}

}  // namespace detail

/// Perspective projection.
///
/// @param tan_half_x               tangent of half the opening angle along x, > 0
/// @param tan_half_y               tangent of half the opening angle along y, > 0
/// @param z_near                   distance of the near plane, world units, 0 < z_near < z_far
/// @param z_far                    distance of the far plane, world units. Infinite: there is no far plane, and depth
///                                 nears the far depth with distance, forward or reversed
/// @param clip                     clip space that the matrix leads to
/// @throws std::invalid_argument   values outside these ranges; clip unset; a matrix that would not be finite
/// @formula       z/w = A + B / distance through (z_near, near depth), (z_far, far depth)
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip) {
    const auto opening = [](T tangent) { return tangent > T(0) && detail::is_normal(T(1) / tangent); };
    detail::require(opening(tan_half_x), "perspective", "tan_half_x", "above 0, with a normal inverse", tan_half_x);
    detail::require(opening(tan_half_y), "perspective", "tan_half_y", "above 0, with a normal inverse", tan_half_y);
    return detail::perspective(tan_half_x, tan_half_y, z_near, z_far, clip, "perspective");
}

/// Orthographic projection of a box in view space.
///
/// @param low              x and y of the box's lower corner, world units, low < high
/// @param high             x and y of the box's upper corner, world units
/// @param z_near           distance in front of the light, world units, z_near < z_far. Negative: behind the light
/// @param z_far            distance in front of the light, world units
/// @param clip             clip space that the matrix leads to
/// @throws std::invalid_argument   an empty or non-finite box; clip unset; a matrix that would not be finite
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip) {
    return detail::orthographic(low, high, z_near, z_far, clip, "orthographic", "low and high", "z_near and z_far");
}

}  // namespace umbrage
