// SPDX-License-Identifier: MIT
//
// View frustum between two distances: perspective, off-axis, orthographic, or for two eyes at once.
//
//     umbrage::frustum<float> slice{.position = eye, .direction = ahead, .tan_half_x = 0.8f, .tan_half_y = 0.5f,
//                                   .z_near = 1, .z_far = 20};
//     umbrage::frustum<float> any = umbrage::make_frustum<float>(
//         {.view = view, .projection = projection, .z_near = 1, .z_far = 20, .clip = clip});
//
// Corners are computed in double for float and double alike.
// Also called: frustum corners, inverse view-projection, off-axis or VR camera (make_frustum, corners).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// View volume of a camera between two distances: all of it, or the slice of a cascade.
/// At a distance z it extends half_size + tan_half z to either side of shift z.
template <real T>
struct frustum {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(0), T(-1)};  ///< direction the camera looks; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint for the up axis; may be parallel to direction
    T tan_half_x = T(1), tan_half_y = T(1);       ///< tangent of half the opening angle, > 0, at most 2^20 (1e6)
    T z_near = T(0.1), z_far = T(100);            ///< distances along direction, 0 <= z_near < z_far, finite
    glm::vec<2, T> shift{T(0)};      ///< off-axis: tangents of the view's center along cross(direction, up) and up,
                                     ///< from -2^20 to 2^20
    glm::vec<2, T> half_size{T(0)};  ///< half size at distance 0, world units, 0 to 2^20 z_far: for two eyes or
                                     ///< orthographic views
};

namespace detail {

/// Check of a struct argument. Its errors name the argument and the member, such as "camera.z_near".
struct member_check {
    const char *function, *argument;

    template <class Value>
    void operator()(bool met, std::string_view member, std::string_view condition, const Value& got) const {
        if (!met) refuse(function, std::string(argument).append(".").append(member), condition, got);
    }
};

/// Calls must(met, member, condition, value) for each condition of a frustum: see its members.
template <real T, class Must>
void check(const frustum<T>& f, Must&& must) {
    constexpr T widest(0x1p20);  // beyond, double is too coarse for a scene between corners so far away
    const auto opens = [](T tangent, T size) {
        return is_finite(tangent) && tangent <= widest && (tangent > T(0) || (tangent == T(0) && size > T(0)));
    };
    must(all_finite(f.half_size) && f.half_size.x >= T(0) && f.half_size.y >= T(0), "half_size", "finite, 0 or more",
         f.half_size);
    constexpr auto opening = "above 0 and at most 2^20, or 0 with a half_size";
    must(opens(f.tan_half_x, f.half_size.x), "tan_half_x", opening, f.tan_half_x);
    must(opens(f.tan_half_y, f.half_size.y), "tan_half_y", opening, f.tan_half_y);
    must(all_finite(f.shift) && glm::abs(f.shift.x) <= widest && glm::abs(f.shift.y) <= widest, "shift",
         "from -2^20 to 2^20", f.shift);
    must(f.z_near >= T(0), "z_near", "0 or more", f.z_near);
    must(is_finite(f.z_far) && f.z_near < f.z_far, "z_far", "finite and above z_near", f.z_far);
    must((glm::max)(f.half_size.x, f.half_size.y) <= widest * f.z_far, "half_size", "at most 2^20 z_far", f.half_size);
    must(all_finite(f.position), "position", "finite", f.position);
    must(all_finite(f.direction), "direction", "finite", f.direction);
    must(all_finite(f.up), "up", "finite", f.up);
    must(f.direction != glm::vec<3, T>(0), "direction", "of a length above 0", f.direction);
}

/// Reports an invalid frustum.
template <real T>
void require_frustum(const frustum<T>& f, const char* function, const char* argument) {
    check(f, member_check{function, argument});
}

template <real T>
[[nodiscard]] frustum<double> in_double(const frustum<T>& f) {
    return {glm::dvec3(f.position), glm::dvec3(f.direction), glm::dvec3(f.up),
            double(f.tan_half_x),   double(f.tan_half_y),    double(f.z_near),
            double(f.z_far),        glm::dvec2(f.shift),     glm::dvec2(f.half_size)};
}

/// Axes of a frustum as columns: side, up and forward.
template <real T>
[[nodiscard]] glm::dmat3 axes(const frustum<T>& f, const char* function, const char* argument = "frustum") {
    require_frustum(f, function, argument);
    const auto view = look_along(glm::dvec3(f.position), glm::dvec3(f.direction), glm::dvec3(f.up), handedness::right,
                                 function, "position");
    return {{view[0][0], view[1][0], view[2][0]},
            {view[0][1], view[1][1], view[2][1]},
            {-view[0][2], -view[1][2], -view[2][2]}};
}

/// True if the frustum shrinks distant objects. Warps take no other frustum.
template <real T>
[[nodiscard]] bool is_perspective(const frustum<T>& f) {
    return f.tan_half_x > T(0) && f.tan_half_y > T(0);
}

/// Frustum of one eye that contains the frustum of two, from behind them. A frustum of one eye is returned as is.
template <real T>
[[nodiscard]] frustum<double> of_one_eye(const frustum<T>& camera, const char* function) {
    frustum<double> f = in_double(camera);
    if (!is_perspective(f)) return f;
    const double back = (glm::max)(f.half_size.x / f.tan_half_x, f.half_size.y / f.tan_half_y);
    f.position -= axes(camera, function, "camera") * glm::dvec3(f.shift, 1.0) * back;
    f.z_near += back, f.z_far += back, f.half_size = glm::dvec2(0);
    return f;
}

}  // namespace detail

/// Corners of a frustum, in world units.
using eight_corners = std::array<glm::dvec3, 8>;

namespace detail {

/// corners, with errors in the name of `function`.
template <real T>
[[nodiscard]] eight_corners corners_for(const char* function, const frustum<T>& f) {
    const glm::dmat3 axes = detail::axes(f, function);
    const glm::dvec2 tangents(f.tan_half_x, f.tan_half_y), size(f.half_size), shift(f.shift);
    eight_corners all;
    for (std::size_t i = 0; i < 8; ++i) {
        const auto z = double(i & 4 ? f.z_far : f.z_near);
        const glm::dvec2 half = size + z * tangents;
        const glm::dvec2 at = glm::dvec2(i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y) + shift * z;
        all[i] = glm::dvec3(f.position) + axes * glm::dvec3(at, z);
    }
    return all;
}

}  // namespace detail

/// Corners of a frustum. The bits of an index select right, up and far.
/// @throws std::invalid_argument  an invalid frustum: see its members
template <real T>
[[nodiscard]] eight_corners corners(const frustum<T>& f) {
    return detail::corners_for("corners", f);
}

/// Matrices of a camera, from which make_frustum takes its frustum.
template <real T = float>
struct camera_matrices {
    glm::mat<4, 4, T> view{T(1)};                  ///< world to view space of the camera, or of the head
    glm::mat<4, 4, T> projection{T(1)};            ///< view space to clip space; its depth row is not read
    std::optional<glm::mat<4, 4, T>> other_eye{};  ///< second projection of two eyes. Each then includes head to eye
    T z_near = T(0.1), z_far = T(100);             ///< range of the shadows along the view, 0 <= z_near < z_far, finite
    clip_space clip{};                             ///< required: clip space of your API or engine, see clip_space.hpp
};

namespace detail {

/// Bounds of camera views, x and y in view space: low + low_slope z and high + high_slope z at a distance z.
struct view_bounds {
    glm::dvec2 low{highest<double>}, high{-highest<double>}, low_slope{highest<double>}, high_slope{-highest<double>};
};

/// Adds the four edges of a camera's view, in each of which two of its sides meet.
template <real T>
void add_edges(view_bounds& bounds, const camera_matrices<T>& camera, const glm::mat<4, 4, T>& projection,
               const char* argument) {
    constexpr auto function = "make_frustum";
    require(all_finite(projection), function, argument, "finite", projection);
    glm::dmat4 rows = glm::transpose(glm::dmat4(projection));
    if (camera.clip.hand == handedness::right)
        for (glm::length_t i = 0; i < 4; ++i) rows[i].z = -rows[i].z;  // z as a distance
    for (int i = 0; i < 4; ++i) {
        const glm::dvec4 a = rows[0] + (i & 1 ? -1.0 : 1.0) * rows[3], b = rows[1] + (i & 2 ? -1.0 : 1.0) * rows[3];
        const double area = a.x * b.y - a.y * b.x;
        const glm::dvec2 at = glm::dvec2(a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w) / area;
        const glm::dvec2 slope = glm::dvec2(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z) / area;
        const auto w = [&](T z) { return glm::dot(rows[3], glm::dvec4(at + double(z) * slope, double(z), 1.0)); };
        require(all_finite(at) && all_finite(slope) && w(camera.z_far) > 0.0 &&
                    w(camera.z_near) >= -0x1p-20 * w(camera.z_far),
                function, argument, "such that its four edges run ahead", projection,
                "Is clip that of the camera, and the view's z the head's?");
        bounds.low = (glm::min)(bounds.low, at), bounds.high = (glm::max)(bounds.high, at);
        bounds.low_slope = (glm::min)(bounds.low_slope, slope),
        bounds.high_slope = (glm::max)(bounds.high_slope, slope);
    }
}

}  // namespace detail

/// Frustum of a camera's matrices: perspective, off-axis or orthographic, with forward or reversed depth, with or
/// without a far plane.
///
/// For two eyes the result contains both views. It also contains the view of an eye that is rotated from the head.
/// Its sides depend on the projections alone, so that stable cascades stay stable while the view moves.
/// With two eyes each projection must keep its bits: use the eyes relative to the head, as headsets give them.
///
/// @return        frustum with distances along the view from its origin: -z of view space if right-handed, else z
/// @throws std::invalid_argument  a view that is not a rotation and a translation; projections whose edges do not run
///                                ahead from z_near on; planes out of order; clip unset; values that are not finite
template <real T = float>
[[nodiscard]] frustum<T> make_frustum(const camera_matrices<T>& camera) {
    constexpr auto function = "make_frustum";
    detail::require_given(camera.clip, function);
    detail::require(camera.z_near >= T(0), function, "z_near", "0 or more", camera.z_near);
    detail::require(is_finite(camera.z_far) && camera.z_near < camera.z_far, function, "z_far",
                    "finite and above z_near", camera.z_far);
    const glm::dmat4 view(camera.view);
    const glm::dmat3 turn(view), turned = glm::transpose(turn), whole = turn * turned;
    double askew = 0.0;
    for (glm::length_t i = 0; i < 9; ++i) askew = (glm::max)(askew, glm::abs(whole[i / 3][i % 3] - (i % 4 ? 0 : 1)));
    detail::require(detail::all_finite(view) && askew < 1e-3, function, "view", "a rotation and a translation",
                    camera.view);
    detail::view_bounds b;
    detail::add_edges(b, camera, camera.projection, "projection");
    if (camera.other_eye) detail::add_edges(b, camera, *camera.other_eye, "other_eye");

    const glm::dvec3 ahead = camera.clip.hand == handedness::right ? -turned[2] : turned[2];
    const double side = glm::dot(glm::cross(ahead, turned[1]), turned[0]) < 0.0 ? -1.0 : 1.0;
    const glm::dvec2 half = (glm::max)((b.high - b.low) * 0.5, glm::dvec2(0)), middle = (b.high + b.low) * 0.5;
    const glm::dvec2 tangents = (b.high_slope - b.low_slope) * 0.5, shift = (b.high_slope + b.low_slope) * 0.5;
    const frustum<T> f{glm::vec<3, T>(turned * (glm::dvec3(middle, 0.0) - glm::dvec3(view[3]))),
                       glm::vec<3, T>(ahead),
                       glm::vec<3, T>(turned[1]),
                       T(tangents.x),
                       T(tangents.y),
                       camera.z_near,
                       camera.z_far,
                       glm::vec<2, T>(side * shift.x, shift.y),
                       glm::vec<2, T>(half)};
    detail::require_frustum(f, function, "projection's frustum");
    return f;
}

}  // namespace umbrage
