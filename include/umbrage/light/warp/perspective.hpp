// SPDX-License-Identifier: MIT
//
// Perspective shadow maps: a light's map of the world as the camera's own perspective shrinks it, so that what is small
// on the screen is small in the map. Whatever stands where, rays are texels: the light itself goes through the camera's
// perspective, from which it comes out as a point that shines, as one that swallows the light, or infinitely far.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     umbrage::perspective_light<float> warped = umbrage::fit_perspective(fit);
//     if (warped.seen_as == umbrage::light_image::none) report("light-space perspective in its place");
//
#pragma once

#include <cmath>
#include <limits>
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

#include <umbrage/light/bounds.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// What becomes of a light in the camera's perspective.
enum class light_image {
    source,    ///< a light before the camera: rays leave a point
    sink,      ///< one behind it: they end in a point
    parallel,  ///< one abreast of it: they stay parallel, or nearly
    none       ///< a point amid the receivers, or too close to them: not warped so
};

template <real T>
struct perspective_light : warped_light<T> {
    light_image seen_as = light_image::none;  ///< none: what stands in its place
};

namespace detail {

/// World to a camera's NDC, in double: the camera moved back, its planes around points.
template <real T>
[[nodiscard]] glm::dmat4 slid_back(const frustum<T>& camera, const std::vector<glm::dvec3>& points, double slide,
                                   const char* function) {
    const glm::dvec3 eye(camera.position), ahead = axes(camera)[2];
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const glm::dvec3& p : points) {
        const double z = glm::dot(p - eye, ahead);
        least = glm::min(least, z), greatest = glm::max(greatest, z);
    }
    const double back = slide - glm::min(least, 0.0), z_near = least + back;
    const double z_far = glm::max(greatest + back, z_near * (1.0 + 0x1p-8));
    require(is_finite(z_far), function, "receivers", "lie too far from the camera");
    const glm::dmat4 view =
        look_along(eye - back * ahead, ahead, glm::dvec3(camera.up), handedness::right, function, "camera");
    return perspective(double(camera.tan_half_x), double(camera.tan_half_y), z_near, z_far, opengl_clip_space,
                       function) *
           view;
}

/// The least and the greatest of angles at which a view sees points, in x and in y.
struct angles {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};
/// @return   nothing where one of them is not before it
[[nodiscard]] inline std::optional<angles> angles_of(const glm::dmat4& view, const std::vector<glm::dvec3>& points) {
    angles a;
    for (const glm::dvec3& p : seen(view, points)) {
        if (!(p.z < 0.0)) return {};
        const glm::dvec2 angle(std::atan2(p.x, -p.z), std::atan2(p.y, -p.z));
        a.low = glm::min(a.low, angle), a.high = glm::max(a.high, angle);
    }
    return a;
}

/// From the camera's NDC to a map in which rays of the light are texels: x, y, depth and w.
/// @param light       in NDC, homogeneous
/// @param receivers   in NDC
/// @return            nothing where the light sees them under more than 150 degrees
[[nodiscard]] inline std::optional<glm::dmat4> along_rays(const glm::dvec4& light,
                                                          const std::vector<glm::dvec3>& receivers, light_image seen_as,
                                                          const char* function) {
    const auto look = [&](glm::dvec3 from, glm::dvec3 along, glm::dvec3 up) {
        return look_along(from, along, up, handedness::right, function, "direction");
    };
    const auto [low, high] = extent_of(receivers);
    const glm::dvec3 middle = (low + high) * 0.5, up(0, 0, 1);
    glm::dmat4 depth(1.0);
    depth[2][2] = -1.0;
    if (seen_as == light_image::parallel) return depth * look(middle, -glm::dvec3(light), up);

    const glm::dvec3 from = glm::dvec3(light) / light.w;
    // from beyond the far plane all of NDC lies that way; then along the middle of the angles between which it lies
    const glm::dmat4 first = from.z > 1.0 ? look(from, {0, 0, -1}, {0, 1, 0}) : look(from, middle - from, up);
    const auto around = angles_of(first, receivers);
    if (!around) return {};
    const glm::dvec2 halfway = glm::tan((around->low + around->high) * 0.5);
    const glm::dmat4 view = look(from, glm::transpose(glm::dmat3(first)) * glm::dvec3(halfway, -1.0), up);
    const auto opening = angles_of(view, receivers);
    constexpr double widest = 150.0 / 180.0 * std::numbers::pi;
    if (!opening || glm::any(glm::greaterThan(opening->high - opening->low, glm::dvec2(widest)))) return {};
    // depth over w is a distance's inverse: of a sink's, where the far is near, the other way round
    const double distance = -(view * glm::dvec4(middle, 1.0)).z;
    depth[2] = {0, 0, 0, -1};
    depth[3] = {0, 0, seen_as == light_image::source ? -distance : distance, 0};
    return depth * view;
}

/// The map of a light, homogeneous: the way towards it and 0, or its position and 1.
/// @param casters   that lie before w = 0
/// @param instead   () -> warped_light<T>, where there is no such map
template <real T, class Instead>
[[nodiscard]] perspective_light<T> perspective_of(const glm::dvec4& light, const warp_fit<T>& fit,
                                                  const polyhedron& casters, T slide, const char* function,
                                                  Instead&& instead) {
    require(is_normal(slide) && slide > T(0), function, "slide", "must be above 0 and finite");
    const std::vector<glm::dvec3> receivers = corners_of(fit.receivers);
    const glm::dmat4 to_ndc = slid_back(fit.camera, receivers, double(slide), function);
    const glm::dvec4 image = to_ndc * light;
    const bool far = !(glm::abs(image.w) >= 1e-4 * glm::length(glm::dvec3(image)));
    const light_image seen_as = far ? light_image::parallel : image.w > 0 ? light_image::source : light_image::sink;
    std::vector<glm::dvec3> in_ndc;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = to_ndc * glm::dvec4(p, 1.0);
        in_ndc.push_back(glm::dvec3(h) / h.w);
    }
    if (const auto to_map = along_rays(image, in_ndc, seen_as, function))
        if (const auto warped = refit(*to_map * to_ndc, fit, casters, function)) return {*warped, seen_as};
    return {instead(), light_image::none};
}

}  // namespace detail

/// The map of a directional light through the camera's perspective. The map is what it is wherever casters stand, w
/// being the same all along a ray: those behind the camera need no more of a slide.
///
/// Between the images of the light, and while both camera and light move, the map changes without a jump; where
/// light_space_perspective takes its place there is one.
///
/// @param slide   how far behind its place the camera is taken for the warp, world units, > 0; its least distance to
///                receivers. Less gives more of the map to what is close
/// @return        light_image::none and fit_light_space_perspective where the light, or the point opposite, stands amid
///                what the camera sees, which then fills more than 150 degrees around it
/// @throws std::invalid_argument  as fit_light_space_perspective does, and slide not above 0
/// @cite          Stamminger, Drettakis: Perspective Shadow Maps, SIGGRAPH 2002
template <real T = float>
[[nodiscard]] perspective_light<T> fit_perspective(const warp_fit<T>& fit, T slide = T(1)) {
    constexpr auto function = "fit_perspective";
    detail::require_warp_fit(fit, function);
    const glm::dmat4 view = detail::light_frame(detail::view_of(fit, function), fit.clip.hand);
    const polyhedron casters = fit.casters ? polyhedron(*fit.casters) : polyhedron();
    return detail::perspective_of(glm::dvec4(-view[0][2], -view[1][2], -view[2][2], 0.0), fit, casters, slide, function,
                                  [&] { return fit_light_space_perspective(fit); });
}

}  // namespace umbrage
