// SPDX-License-Identifier: MIT
//
// What warps of a directional light's map share: what they are fitted to, what they give, and their last step, which
// lays any projective map of the world around the receivers.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     umbrage::warped_light<float> warped = umbrage::fit_light_space_perspective(fit);
//     draw_depths(warped.light);
//
// A warp gives what the camera sees close by more texels, and what it sees from afar fewer. Look-ups are those of a
// spot light, by shadow_coordinate and project_coordinate; w is above 0 and depth grows along the light.
//
// Under low lights, 6 to 14 degrees above a ground, a warp can resolve far less than a map without one: take the better
// of both by choose_light.
//
// What is strongly warped wants digits: a matrix of doubles, rounded once, places points to 1/1000 of a texel of maps
// of 2048 under a view of a kilometre. Its product with points in float loses more far from the origin, up to 1/28 of a
// texel at the corners of that view; points told from the camera lose least.
#pragma once

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
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>

namespace umbrage {

template <real T = float>
struct warp_fit {
    frustum<T> camera{};                          ///< that the map is for
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< of the light, any length > 0
    std::optional<hull> receivers{};              ///< required: what the camera sees of the scene; where that is
                                                  ///< nothing, the camera's frustum stands for it
    std::optional<bounding_box<T>> casters{};     ///< none: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);                           ///< added on every side, as a share of the receivers' extent in the
                                                  ///< map, 0 to 1000
    clip_space clip{};                            ///< required: your API's or engine's, see clip_space.hpp
};

template <real T>
struct warped_light {
    light_space<T> light;  ///< for depth pass and texture_matrix; w is 1 at the least receiver
    T strength = T(0);     ///< 1 - least w / greatest w of the receivers: 0 uniform, towards 1 ever more warped. Says
                           ///< nothing of quality: see choose_light
};

namespace detail {

/// A fit that has what all warps need, or a complaint; `instead` stands for receivers that are none.
template <real T>
[[nodiscard]] warp_fit<T> completed(warp_fit<T> fit, const hull& instead, const char* function) {
    require_given(fit.clip, function);
    if (given(fit.receivers, function).points.empty()) fit.receivers = instead;
    // beyond that float has no digits left for the receivers, and rows of the matrix become multiples of w's
    require(is_finite(fit.margin) && fit.margin >= T(0) && fit.margin <= T(1000), function, "margin", "from 0 to 1000",
            fit.margin);
    if (fit.casters) require_box(*fit.casters, function, "casters");
    return fit;
}

/// Falls back to the camera's frustum where the camera sees nothing of the scene.
template <real T>
[[nodiscard]] warp_fit<T> completed(const warp_fit<T>& fit, const char* function) {
    require_frustum(fit.camera, function, "camera");
    return completed(fit, fit.camera, function);
}

/// The way y goes in a map: the way the camera looks, or the camera's up where the sine between its view and the light
/// is below 1e-3. Maps are not warped there, but turn at once as the sine passes 1e-3: their texels then shimmer.
template <real T>
[[nodiscard]] glm::dvec3 up_of(const warp_fit<T>& fit, const char* function) {
    const glm::dmat3 camera = axes(fit.camera, function, "camera");
    const bool along = !(glm::length(glm::cross(camera[2], unit(glm::dvec3(fit.direction)))) > 1e-3);
    return camera[along ? 1 : 2];
}

/// The light's view that maps are drawn in.
template <real T>
[[nodiscard]] glm::dmat4 view_of(const warp_fit<T>& fit, const char* function) {
    return look_along(glm::dvec3(0), glm::dvec3(fit.direction), up_of(fit, function), fit.clip.hand, function, "");
}

/// Least and greatest depth in a map of a body within planes of the map's space.
/// @return   highest and -highest where there is none of it; -highest and highest, around which no map can be laid,
///           where some of it does not lie in front of w = 0
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
            least = lesser(least, h.z / h.w), greatest = greater(greatest, h.z / h.w);
        }
    }
    return {least, greatest};
}

/// A projective map of which a box becomes the clip space's cube; turned over where it would mirror what it sees.
/// @param to_map           world to x, y, depth and w, in double; keeps x / w and y / w along the light, where depth
///                         z / w grows; of any scale
/// @param least, greatest  w of receivers
/// @return                 nothing where the box has no extent or an infinite one, and where the map overflows
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
    const T bend = glm::length(glm::vec<3, T>(rows[3]));  // a row that says w alone is one too
    for (glm::length_t i = 0; i < 3; ++i)
        if (!is_normal(glm::length(glm::vec<3, T>(rows[i])) + bend)) return {};
    return warped_light<T>{light, T(1.0 - least / greatest)};
}

/// A map laid around the receivers in x and y, in depth around them and what of the casters they sweep towards the
/// light.
/// @param to_map   as for laid
/// @return         nothing where w <= 0 at a receiver or a caster, and as laid does
template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const polyhedron& casters, const char* function) {
    std::vector<glm::dvec3> receivers;
    double least_w = detail::highest<double>, greatest_w = 0.0;
    for (const glm::dvec3& p : corners_of(*fit.receivers)) {
        const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
        if (!(h.w > 0.0 && all_finite(h))) return {};
        receivers.push_back(glm::dvec3(h) / h.w);
        least_w = lesser(least_w, h.w), greatest_w = greater(greatest_w, h.w);
    }
    extent box = extent_of(receivers);
    const glm::dvec3 size = box.high - box.low;
    constexpr double flat = 0x1p-8;  // receivers seen edge on have some margin too
    const glm::dvec2 around = double(fit.margin) * greater(glm::dvec2(size), flat * glm::dvec2(size.y, size.x));
    // the hull's cone over the map, of which the other half, behind w = 0, is no part
    const glm::dvec2 swept = depths_within(to_map, casters, sweep(receivers, greater(around.x, around.y)));
    box.low.z = lesser(box.low.z, swept.x);
    const double deep = double(fit.margin) * glm::length(box.high - box.low);
    box.low -= glm::dvec3(around, deep), box.high += glm::dvec3(around, deep);
    return laid(to_map, box, least_w, greatest_w, fit, function);
}

template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const char* function) {
    return refit(to_map, fit, fit.casters ? polyhedron(*fit.casters) : polyhedron(), function);
}

/// Refuses receivers, casters and margin that give a map too large or too small for the numbers.
template <real T>
[[noreturn]] void refuse_size(const warp_fit<T>& fit, const char* function) {
    const extent box = extent_of(corners_of(*fit.receivers));
    refuse(function, "receivers, casters and margin", "such that the map's size is neither too large nor too small",
           box.high - box.low, "That is the receivers' extent.");
}

/// No warp: the map as fit_directional_light lays it, but with the margin and the way up of warps.
template <real T>
[[nodiscard]] warped_light<T> unwarped(const warp_fit<T>& fit, const char* function) {
    const auto light = refit(light_frame(view_of(fit, function), fit.clip.hand), fit, function);
    if (!light) refuse_size(fit, function);
    return *light;
}

}  // namespace detail
}  // namespace umbrage
