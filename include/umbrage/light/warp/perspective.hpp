// SPDX-License-Identifier: MIT
//
// Perspective shadow maps (PSM): a light's map of the world after the camera's own perspective. Objects that are small
// on the screen are then small in the map. The light itself passes through the camera's perspective. Its image there is
// a point where rays start, a point where rays end, or infinitely far away. Each ray falls on one point of the map.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     umbrage::perspective_light<float> warped = umbrage::fit_perspective(fit);
//     if (warped.seen_as == umbrage::light_image::none) report("light-space perspective instead");
//
// Also called: PSM, perspective shadow maps (fit_perspective).
// See also: light_space_perspective.hpp, which is simpler; trapezoidal.hpp.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/light_position.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// Image of a light in the camera's perspective.
enum class light_image {
    source,    ///< light in front of the camera: rays leave a point
    sink,      ///< light behind the camera: rays end in a point
    parallel,  ///< light beside the camera: rays stay parallel, or nearly
    none       ///< image among the receivers or too close to them, no perspective, or T too coarse: another map
};

/// Perspective shadow map (PSM), and how the camera sees its light.
template <real T>
struct perspective_light : warped_light<T> {
    light_image seen_as = light_image::none;  ///< none: the light has another map
};

namespace detail {

/// Matrix from the world to a camera's NDC, in double. The camera is moved back. Its planes enclose the points.
[[nodiscard]] inline glm::dmat4 slid_back(const frustum<double>& camera, const std::vector<glm::dvec3>& points,
                                          double slide, const char* function) {
    const glm::dvec3 eye(camera.position), ahead = axes(camera, function, "camera")[2];
    double least = highest<double>, greatest = -least;
    for (const glm::dvec3& p : points) {
        const double z = glm::dot(p - eye, ahead);
        least = (glm::min)(least, z), greatest = (glm::max)(greatest, z);
    }
    slide = (glm::min)(slide, 0x1p20 * (glm::max)(glm::abs(least), glm::abs(greatest)));
    const double back = slide - (glm::min)(least, 0.0), z_near = least + back;
    const double z_far = (glm::max)(greatest + back, z_near * (1.0 + 0x1p-8));
    require(z_near > 0.0 && is_finite(1024.0 * z_far), function, "receivers",
            "near enough to the camera and the origin for finite distances", glm::dvec2(z_near, z_far));
    const glm::dmat4 view =
        look_along(eye - back * ahead, ahead, glm::dvec3(camera.up), handedness::right, function, "camera");
    const glm::dvec2 tangents(camera.tan_half_x, camera.tan_half_y);
    glm::dmat4 projection = perspective(tangents.x, tangents.y, z_near, z_far, opengl_clip_space, function);
    projection[2] += glm::dvec4(camera.shift / tangents, 0.0, 0.0);
    return projection * view;
}

/// Smallest and largest angles of points in x and in y, with z ahead.
struct angles {
    glm::dvec2 low{highest<double>}, high{-highest<double>};
    bool all_ahead = true;  ///< false if a point does not lie ahead; the angles are then unset
};
template <class = on_use>
[[nodiscard]] angles angles_of(const std::vector<glm::dvec3>& points) {
    angles a;
    for (const glm::dvec3& p : points) {
        if (!(p.z > 0.0)) return {.all_ahead = false};
        const glm::dvec2 angle(std::atan2(p.x, p.z), std::atan2(p.y, p.z));
        a.low = (glm::min)(a.low, angle), a.high = (glm::max)(a.high, angle);
    }
    return a;
}

/// Point in NDC on the map's axis: halfway between the angles at which the light's image sees receivers.
/// @return   nothing if the image stands among the receivers
template <class = on_use>
[[nodiscard]] std::optional<glm::dvec3> aim(const glm::dvec3& image, const std::vector<glm::dvec3>& receivers,
                                            const char* function) {
    const auto [low, high] = extent_of(receivers);
    const glm::dvec3 middle = (low + high) * 0.5;
    // from beyond the far plane all of NDC lies in one direction
    const glm::dvec3 ahead = image.z > 1.0 ? glm::dvec3(0, 0, -1) : middle - image;
    const glm::dmat4 first = light_frame(
        look_along(image, ahead, glm::dvec3(0, 1, 0), handedness::right, function, "camera"), handedness::right);
    const angles around = angles_of(seen(first, receivers));
    if (!around.all_ahead) return {};
    const glm::dvec2 halfway = glm::tan((around.low + around.high) * 0.5);
    const glm::dvec3 axis = unit(glm::transpose(glm::dmat3(first)) * glm::dvec3(halfway, 1.0));
    return image + axis * glm::dot(middle - image, axis);
}

/// Map whose texels are rays, and the angle that receivers fill around the light's image. pi or more: it is among them.
struct ray_map {
    glm::dmat4 to_map;  ///< to x, y, depth and w
    double opening;
};

/// Map for sources and sinks alike, and for all between. The light passes through the aim along u, curved by k. k is
/// above 0 for sources.
/// @param light       light in NDC, homogeneous
/// @param up          up axis of the map, in NDC at the aim
/// @param receivers   receivers in NDC
/// @formula           u = -(l.xyz - l.w aim) / r, k = l.w / r, r its length; depth = u.(p - aim), w = 1 + k depth
template <class = on_use>
[[nodiscard]] ray_map along_rays(const glm::dvec4& light, const glm::dvec3& aim, const glm::dvec3& up,
                                 const std::vector<glm::dvec3>& receivers, const char* function) {
    const glm::dvec3 back = glm::dvec3(light) - aim * light.w;
    const double bend = light.w / glm::length(back);
    glm::dmat4 rays = light_frame(look_along(aim, -back, up, handedness::right, function, "camera"), handedness::right);
    for (glm::length_t i = 0; i < 4; ++i) rays[i][3] += bend * rays[i][2];

    std::vector<glm::dvec3> ahead;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = rays * glm::dvec4(p, 1.0);
        ahead.emplace_back(h.x * glm::abs(bend), h.y * glm::abs(bend), h.w);
    }
    const angles seen = angles_of(ahead);
    if (!seen.all_ahead) return {rays, std::numbers::pi};
    const glm::dvec2 opening = seen.high - seen.low;
    return {rays, (glm::max)(opening.x, opening.y)};
}

/// Fraction of the fallback map at this opening angle: none up to 120 degrees, all of it from 150 degrees on.
[[nodiscard]] inline double share_of_stand_in(double opening) {
    constexpr double degree = std::numbers::pi / 180.0;
    return glm::clamp((opening - 120.0 * degree) / (30.0 * degree), 0.0, 1.0);
}

/// Map whose receivers fill -1 to 1, without a mirror. The smallest w of the receivers is 1. Such maps of one light can
/// be blended, since each ray falls on one point in all of them.
template <class = on_use>
[[nodiscard]] glm::dmat4 filled(const glm::dmat4& to_map, const hull& receivers) {
    extent box;
    double least = highest<double>;
    for (const glm::dvec3& p : corners_of(receivers)) {
        const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
        box.low = (glm::min)(box.low, glm::dvec3(h) / h.w), box.high = (glm::max)(box.high, glm::dvec3(h) / h.w);
        least = (glm::min)(least, h.w);
    }
    const glm::dvec3 size = box.high - box.low;
    glm::dvec3 scale = 2.0 / (glm::max)(size, glm::dvec3(0x1p-8 * (glm::max)((glm::max)(size.x, size.y), size.z)));
    if (glm::determinant(to_map) < 0.0) scale.x = -scale.x;
    glm::dmat4 placed(1.0);
    for (glm::length_t i = 0; i < 3; ++i)
        placed[i][i] = scale[i], placed[3][i] = -0.5 * scale[i] * (box.low[i] + box.high[i]);
    return placed * to_map / least;
}

/// Map of a light. The homogeneous light is the direction towards it and 0, or its position and 1.
/// @param stand_in   fallback map of the light: world to x, y, depth and w
/// @param instead    () -> warped_light<T>, the light with the fallback map
/// @param frame      frame of the light, whose y is the map's
template <real T, class Instead>
[[nodiscard]] perspective_light<T> perspective_of(const glm::dvec4& light, const warp_fit<T>& fit,
                                                  const polyhedron& casters, T slide, const char* function,
                                                  const glm::dmat4& frame, const glm::dmat4& stand_in,
                                                  Instead&& instead) {
    require(is_normal(slide) && slide > T(0), function, "slide", "above 0 and finite", slide);
    if (!is_perspective(fit.camera)) return {instead(), light_image::none};
    const std::vector<glm::dvec3> receivers = corners_of(*fit.receivers);
    const glm::dmat4 to_ndc = slid_back(of_one_eye(fit.camera, function), receivers, double(slide), function);
    const glm::dvec4 image = to_ndc * light;
    std::vector<glm::dvec3> in_ndc;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = to_ndc * glm::dvec4(p, 1.0);
        in_ndc.push_back(glm::dvec3(h) / h.w);
    }
    const bool at_infinity = !(glm::abs(image.w) >= 1e-4 * glm::length(glm::dvec3(image)));
    const auto middle = at_infinity ? glm::dvec3(0) : aim(glm::dvec3(image) / image.w, in_ndc, function);
    if (middle) {
        const auto [low, high] = extent_of(in_ndc);
        const glm::dvec4 y = to_ndc * glm::dvec4(frame[0][1], frame[1][1], frame[2][1], 0.0);
        // as the fallback map has it on the camera's axis, for a light among the receivers: both rotate alike
        const glm::dvec3 up = glm::dvec3(y) - light.w * 0.5 * (low + high) * y.w;
        const auto [rays, opening] = along_rays(image, *middle, up, in_ndc, function);
        const double share = share_of_stand_in(opening);
        glm::dmat4 to_map = rays * to_ndc;
        if (share > 0.0 && share < 1.0)
            to_map = (1.0 - share) * filled(to_map, *fit.receivers) + share * filled(stand_in, *fit.receivers);
        const auto warped = share < 1.0 ? refit(to_map, fit, casters, function) : std::nullopt;
        if (warped)
            return {*warped, at_infinity   ? light_image::parallel
                             : image.w > 0 ? light_image::source
                                           : light_image::sink};
    }
    return {instead(), light_image::none};
}

}  // namespace detail

/// Map of a directional light through the camera's perspective.
///
/// Under lights 6 to 14 degrees above a ground it can resolve far less than a map without a warp: see choose_light.
/// Casters behind the camera need no larger slide: w is constant along a ray, and depth continues.
///
/// The map changes without a jump while camera and light move, and between the kinds of image too. It blends into
/// fit_light_space_perspective while the visible receivers fill 120 to 150 degrees around the light's image.
///
/// @param fit     camera, light, receivers and casters
/// @param slide   distance to move the camera back for the warp, world units, > 0: the smallest distance to receivers.
///                Smaller values give more of the map to close receivers. 2^20 times the distance of the farthest
///                receivers replaces larger values: hardly a warp is left there
/// @return        warped light. light_image::none with fit_light_space_perspective if the visible receivers fill 150
///                degrees or more around the light, or around the point opposite
/// @edge          T is too coarse for the receivers in the map, see warp_fit.hpp: light_image::none. A slide of 1e-15
///                for receivers at the camera is such a case
/// @throws std::invalid_argument  as fit_light_space_perspective; slide not above 0
/// @cite          Stamminger, Drettakis: Perspective Shadow Maps, SIGGRAPH 2002
template <real T = float>
[[nodiscard]] perspective_light<T> fit_perspective(const warp_fit<T>& fit, T slide = T(1)) {
    constexpr auto function = "fit_perspective";
    const warp_fit<T> whole = detail::completed(fit, function);
    const detail::along_view v = detail::make_along_view(whole, function);
    const glm::dvec4 light(-v.frame[0][2], -v.frame[1][2], -v.frame[2][2], 0.0);
    const polyhedron casters = fit.casters ? polyhedron(*fit.casters) : polyhedron();
    const double n = detail::default_distance(v);
    return detail::perspective_of(light, whole, casters, slide, function, v.frame, detail::map_along(v, n),
                                  [&] { return detail::warped_along(v, n, whole, function); });
}

/// Map of a point light (such as a spot light) through the camera's perspective. In front of the camera the light is a
/// source, and behind it a sink.
///
/// @param fit    its direction is the light's axis
/// @param from   position of the light, and its near plane
/// @param slide  as for a directional light
/// @return       warped light. If the light stands among the visible receivers: light_image::none, and the view along
///               its axis without a warp
/// @edge         receivers without points: a map of the space right in front of the light
/// @throws std::invalid_argument  receivers that do not all lie along the axis beyond z_near; z_near not above 0;
///                                errors of fit_perspective above
template <real T>
[[nodiscard]] perspective_light<T> fit_perspective(const warp_fit<T>& fit, const light_position<T>& from,
                                                   T slide = T(1)) {
    constexpr auto function = "fit_perspective";
    const warp_fit<T> whole = detail::completed(fit, from, function);
    const detail::axis_view own = detail::view_of(from, whole, function);
    return detail::perspective_of(glm::dvec4(glm::dvec3(from.position), 1.0), whole, own.casters, slide, function,
                                  own.frame, detail::map_along(own),
                                  [&] { return detail::unwarped(own, whole, function); });
}

}  // namespace umbrage
