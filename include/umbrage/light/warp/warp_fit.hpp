// SPDX-License-Identifier: MIT
//
// Warps of a directional light's map: their common input and output, and their last step. The step fits any projective
// map of the world to the receivers. See light_space_perspective.hpp, trapezoidal.hpp, perspective.hpp.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     umbrage::warped_light<float> warped = umbrage::fit_light_space_perspective(fit);
//     draw_depths(warped.light);
//
// A warp gives more texels to surfaces close to the camera, and fewer to distant ones. Lookups are those of a spot
// light, with `shadow_coordinate` and `project_coordinate`. w is above 0. Depth grows along the light.
//
// Under low lights (6 to 14 degrees above a ground) a warp can resolve far less than a map without one. Use
// `choose_light` to take the better of both.
//
// Strong warps need precision. A matrix computed in double and rounded once places points to 1/1000 texel, for maps of
// 2048 texels under a view of one kilometer. Its product with points in float loses more far from the origin, up to
// 1/28 texel at the corners of that view. Camera-relative coordinates lose the least precision.
//
// Far from the origin, float (and finally double) runs out of precision. A fit gives the map without a warp if rounding
// may move receivers out of it. The limit is 1/16 of the map's half size, for any order of operations. If rounding
// could lose receivers there as well, the fit throws.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {

/// Camera, receivers and casters that a warped map is fitted to.
template <real T = float>
struct warp_fit {
    frustum<T> camera{};                          ///< camera that the map is for
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< direction the light travels; any length > 0
    std::optional<hull> receivers{};              ///< required: the part of the scene that the camera sees. If it is
                                                  ///< empty, the camera's frustum replaces it
    std::optional<bounding_box<T>> casters{};     ///< if missing: near plane at the receivers, for near_plane::clamps.
                                                  ///< A point light's is then at its own z_near
    T margin = T(0.01);  ///< border on every side, as a fraction of the receivers' extent in the
                         ///< map, 0 to 1000
    clip_space clip{};   ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Light whose map is warped towards the camera.
template <real T>
struct warped_light {
    light_space<T> light;  ///< light for the depth pass and texture_matrix; the smallest w of the receivers is 1
    T strength = T(0);     ///< 1 - smallest w / largest w of the receivers: 0 uniform, towards 1 more warped. It does
                           ///< not measure quality: see choose_light
};

namespace detail {

/// Fit checked for the needs of all warps. `instead` replaces receivers without points.
template <real T>
[[nodiscard]] warp_fit<T> completed(warp_fit<T> fit, const hull& instead, const char* function) {
    require_given(fit.clip, function);
    if (given(fit.receivers, function).points.empty()) fit.receivers = instead;
    // beyond 1000 float is too coarse for the receivers, and the matrix' rows become multiples of the row of w
    require(is_finite(fit.margin) && fit.margin >= T(0) && fit.margin <= T(1000), function, "margin", "from 0 to 1000",
            fit.margin);
    if (fit.casters) require_box(*fit.casters, function, "casters");
    return fit;
}

/// Fit with a fallback: if the camera sees nothing of the scene, it takes the camera's frustum.
template <real T>
[[nodiscard]] warp_fit<T> completed(const warp_fit<T>& fit, const char* function) {
    require_frustum(fit.camera, function, "camera");
    return completed(fit, fit.camera, function);
}

/// Direction of y in a map: the camera's view direction, or its up axis if the sine between view and light is below
/// 1e-3. Maps are not warped there, but they rotate at once as the sine passes 1e-3, and texels shimmer.
template <real T>
[[nodiscard]] glm::dvec3 up_of(const warp_fit<T>& fit, const char* function) {
    const glm::dmat3 camera = axes(fit.camera, function, "camera");
    const bool along = !(glm::length(glm::cross(camera[2], unit(glm::dvec3(fit.direction)))) > 1e-3);
    return camera[along ? 1 : 2];
}

/// View of the light that maps are drawn in.
template <real T>
[[nodiscard]] glm::dmat4 view_of(const warp_fit<T>& fit, const char* function) {
    return look_along(glm::dvec3(0), glm::dvec3(fit.direction), up_of(fit, function), fit.clip.hand, function, "");
}

/// Smallest and largest depth of a body, clipped to planes of the map's space.
/// @return   highest and -highest if no part lies within. -highest and highest, which no map can hold, if some of it
///           does not lie in front of w = 0
template <class = on_use>
[[nodiscard]] glm::dvec2 depths_within(const glm::dmat4& to_map, const polyhedron& body,
                                       std::vector<glm::dvec4> planes) {
    for (glm::dvec4& plane : planes) plane = glm::transpose(to_map) * plane;
    double least = highest<double>, greatest = -least;
    for (const polyhedron::face& face : body.faces()) {
        std::vector<glm::dvec3> polygon = face.corners;
        for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
        for (const glm::dvec3& p : polygon) {
            const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
            if (!(h.w > 0.0)) return {-highest<double>, highest<double>};
            least = (glm::min)(least, h.z / h.w), greatest = (glm::max)(greatest, h.z / h.w);
        }
    }
    return {least, greatest};
}

/// Sums of what a light's matrices multiply a point by, each product by its magnitude: rounding goes with them.
template <real T>
[[nodiscard]] glm::vec<4, T> magnitudes_at(const light_space<T>& light, const glm::vec<4, T>& point) {
    const auto magnitudes = [](glm::mat<4, 4, T> m) {
        for (glm::length_t i = 0; i < 4; ++i) m[i] = glm::abs(m[i]);
        return m;
    };
    return magnitudes(light.projection) * (magnitudes(light.view) * glm::abs(point));
}

/// True if a light's matrices, with the precision of T, hold points to 1/16 of the map. Sums may be rounded in any
/// order, and fused: each is off by at most 8 roundings of its magnitudes' sum.
template <real T>
[[nodiscard]] bool holds(const light_space<T>& light, const std::vector<glm::dvec3>& points) {
    const glm::mat<4, 4, T> m = light.projection * light.view;
    const T lowest = (glm::min)(ends<T>(light.clip).at_near, ends<T>(light.clip).at_far);
    for (const glm::dvec3& p : points) {
        const glm::vec<4, T> point(glm::vec<3, T>(p), T(1)), h = m * point;
        const glm::vec<4, T> off = T(4) * std::numeric_limits<T>::epsilon() * magnitudes_at(light, point);
        const T least = h.w - off.w, room = least / T(16), most = least + room;
        if (!(least > T(0) && glm::abs(h.x) + off.x <= most && glm::abs(h.y) + off.y <= most && h.z + off.z <= most &&
              h.z - off.z >= lowest * least - room))
            return false;
    }
    return true;
}

/// Light of a projective map that sends a box to clip space's cube. It is flipped if it would mirror.
/// @param to_map           matrix from the world to x, y, depth and w, in double, of any scale. Along the
///                         light x / w and y / w are constant, and depth z / w grows
/// @param least            smallest w of receivers
/// @param greatest         largest w of receivers
/// @return                 nothing if the box has no extent or an infinite one, or if the map overflows
template <real T>
[[nodiscard]] std::optional<warped_light<T>> laid(const glm::dmat4& to_map, const extent& box, double least,
                                                  double greatest, const warp_fit<T>& fit, const char* function) {
    const auto [at_near, at_far] = ends<double>(fit.clip);
    const bool mirrors = (glm::determinant(to_map) < 0.0) != (fit.clip.hand == handedness::right);
    const glm::dvec3 first(mirrors ? 1.0 : -1.0, -1.0, at_near), last(-first.x, 1.0, at_far);
    const glm::dvec3 scale = (last - first) / (box.high - box.low), offset = first - box.low * scale;
    glm::dmat4 placed(1.0);
    for (glm::length_t i = 0; i < 3; ++i) placed[i][i] = scale[i], placed[3][i] = offset[i];

    const glm::dmat4 view = view_of(fit, function);
    const glm::dmat4 projection = placed * to_map * glm::transpose(view) / least;
    const light_space<T> light{glm::mat<4, 4, T>(view), glm::mat<4, 4, T>(projection), fit.clip};
    if (!all_finite(light.projection) || !all_finite(light.projection * light.view)) return {};
    const glm::mat<4, 4, T> rows = glm::transpose(light.projection);
    const T bend = glm::length(glm::vec<3, T>(rows[3]));  // a row with w alone counts too
    for (glm::length_t i = 0; i < 3; ++i)
        if (!is_normal(glm::length(glm::vec<3, T>(rows[i])) + bend)) return {};
    return warped_light<T>{light, T(1.0 - least / greatest)};
}

/// The same, with as much more depth on both sides as the rounding of the light's matrices to T may move points by.
template <real T>
[[nodiscard]] std::optional<warped_light<T>> laid_around(const std::vector<glm::dvec3>& points,
                                                         const glm::dmat4& to_map, extent box, double least,
                                                         double greatest, const warp_fit<T>& fit,
                                                         const char* function) {
    const auto first = laid(to_map, box, least, greatest, fit, function);
    if (!first) return {};
    const light_space<T>& light = first->light;
    double moved = 0.0;  // in clip space
    for (const glm::dvec3& p : points) {
        const glm::dvec4 h = glm::dmat4(light.projection) * (glm::dmat4(light.view) * glm::dvec4(p, 1.0));
        const glm::dvec4 off = double(std::numeric_limits<T>::epsilon()) *
                               glm::dvec4(magnitudes_at(light, glm::vec<4, T>(glm::vec<3, T>(p), T(1))));
        moved = (glm::max)(moved, (off.z + glm::abs(h.z / h.w) * off.w) / h.w);
    }
    const auto [at_near, at_far] = ends<double>(fit.clip);
    moved *= (box.high.z - box.low.z) / glm::abs(at_far - at_near);
    box.low.z -= moved, box.high.z += moved;
    return laid(to_map, box, least, greatest, fit, function);
}

/// Light of a map that is fitted to the receivers in x and y. Its depth also includes the casters in the receivers'
/// sweep towards the light.
/// @param to_map   as for laid
/// @return         nothing if w <= 0 at a receiver or a caster, if laid returns nothing, or if its light does not hold
///                 the receivers
template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const polyhedron& casters, const char* function) {
    const std::vector<glm::dvec3> receivers = corners_of(*fit.receivers);
    std::vector<glm::dvec3> in_map;
    double least_w = detail::highest<double>, greatest_w = 0.0;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
        if (!(h.w > 0.0 && all_finite(h))) return {};
        in_map.push_back(glm::dvec3(h) / h.w);
        least_w = (glm::min)(least_w, h.w), greatest_w = (glm::max)(greatest_w, h.w);
    }
    extent box = extent_of(in_map);
    const glm::dvec3 size = box.high - box.low;
    constexpr double flat = 0x1p-8;  // receivers seen edge-on need some margin too
    const glm::dvec2 around = double(fit.margin) * (glm::max)(glm::dvec2(size), flat * glm::dvec2(size.y, size.x));
    // the hull's cone over the map; its other half behind w = 0 does not count
    const glm::dvec2 swept = depths_within(to_map, casters, sweep(in_map, (glm::max)(around.x, around.y)));
    box.low.z = (glm::min)(box.low.z, swept.x);
    const double deep = double(fit.margin) * glm::length(size);
    box.low -= glm::dvec3(around, deep), box.high += glm::dvec3(around, deep);
    const auto light = laid_around(receivers, to_map, box, least_w, greatest_w, fit, function);
    return light && holds(light->light, receivers) ? light : std::nullopt;
}

template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const char* function) {
    return refit(to_map, fit, fit.casters ? polyhedron(*fit.casters) : polyhedron(), function);
}

/// Reports receivers, casters and margin that give a map too large, too small or too far away for the number type.
template <real T>
[[noreturn]] void refuse_size(const warp_fit<T>& fit, const char* function) {
    const extent box = extent_of(corners_of(*fit.receivers));
    refuse(function, "receivers, casters and margin",
           "such that the map is neither too large, nor too small, nor too far from the origin", box.high - box.low,
           "That is the receivers' extent.");
}

/// Light without a warp: the map of fit_directional_light, but with the margin and up axis of warps.
template <real T>
[[nodiscard]] warped_light<T> unwarped(const warp_fit<T>& fit, const char* function) {
    const auto light = refit(light_frame(view_of(fit, function), fit.clip.hand), fit, function);
    if (!light) refuse_size(fit, function);
    return *light;
}

}  // namespace detail
}  // namespace umbrage
