// SPDX-License-Identifier: MIT
//
// Plane-optimal shadow map: on one plane its texels match the screen's pixels in proportion. It is the best map for a
// ground plane, and for nothing else.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene,
//                                  .clip = clip};
//     auto ground = umbrage::fit_plane_optimal(fit, glm::vec4(0, 1, 0, 0));  // y = 0
//     if (ground) draw_depths(ground->light);                               // else the plane is not seen or not lit
//
// See also: light_space_perspective.hpp for whole scenes.
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
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/light_position.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace umbrage {

/// Bound on the spread of the plane's own depth, which is constant over the map in exact arithmetic. It holds for a
/// matrix computed in double and rounded once to float. Add it to acne_free_bias, which sees no slope there.
/// The light must be 3 degrees or more above the plane, and the camera within 30 units of the world's origin. Farther
/// out the spread grows with that distance.
template <real T>
inline constexpr T plane_optimal_rounding = T(0x1p-18);

namespace detail {

/// Corners of the intersection of a plane and a body: the points where the plane cuts the body's edges.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> crossings(const polyhedron& body, const glm::dvec4& plane) {
    std::vector<glm::dvec3> all;
    for (const polyhedron::face& face : body.faces())
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const glm::dvec3 &p = face.corners[i], &q = face.corners[i + 1 < face.corners.size() ? i + 1 : 0];
            const double at_p = glm::dot(plane, glm::dvec4(p, 1.0)), at_q = glm::dot(plane, glm::dvec4(q, 1.0));
            if ((at_p < 0.0) != (at_q < 0.0)) all.push_back(crossing(p, at_p, q, at_q));
        }
    return all;
}

/// Map of a light. The homogeneous light is the direction towards it and 0, or its position and 1.
/// @param casters   part of the casters in front of w = 0
template <real T>
[[nodiscard]] std::optional<warped_light<T>> plane_optimal_of(const glm::dvec4& light, const warp_fit<T>& fit,
                                                              const polyhedron& casters, const glm::vec<4, T>& plane,
                                                              const char* function) {
    glm::dvec4 ground(plane);
    require(all_finite(plane) && is_normal(glm::length(glm::dvec3(ground))), function, "plane",
            "finite, with a normal other than 0", plane);
    ground /= glm::length(glm::dvec3(ground)) * (glm::dot(ground, light) < 0.0 ? -1.0 : 1.0);
    const double height = glm::dot(ground, light);
    const std::vector<glm::dvec3> seen = crossings(fit.camera, ground);
    if (!(height > 1e-6 * glm::length(light)) || seen.empty()) return {};

    // project along the light onto the plane, then onto the screen; depth is the height above the plane
    const glm::dmat4 cast = glm::dmat4(1.0) - glm::outerProduct(light, ground) / height;
    const glm::dmat3 camera = axes(fit.camera, function, "camera");
    const frustum<double> eye = of_one_eye(fit.camera, function);
    const bool shrinks = is_perspective(eye);
    const glm::dvec2 size = shrinks ? glm::dvec2(eye.tan_half_x, eye.tan_half_y) : eye.half_size;
    const auto row = [&](const glm::dvec3& a) { return glm::dvec4(a, -glm::dot(a, eye.position)) * cast; };
    glm::dmat4 rows;
    rows[0] = row((camera[0] - eye.shift.x * camera[2]) / size.x);
    rows[1] = row((camera[1] - eye.shift.y * camera[2]) / size.y);
    rows[2] = -ground;
    rows[3] = shrinks ? row(camera[2]) : glm::dvec4(0, 0, 0, 1) * cast;
    const glm::dmat4 to_map = glm::transpose(rows);

    double least = highest<double>, greatest = 0.0;
    for (const glm::dvec3& p : seen) {
        const double w = (to_map * glm::dvec4(p, 1.0)).w;
        least = (glm::min)(least, w), greatest = (glm::max)(greatest, w);
    }
    const double above = shrinks ? glm::dot(ground, glm::dvec4(eye.position, 1.0))
                                 : glm::dot(glm::dvec3(ground), camera * glm::dvec3(eye.shift, 1.0));
    if (!(least > 0.0 && glm::abs(above) > 1e-6 * greatest)) return {};
    const double edge = 1.0 + 2.0 * double(fit.margin);
    // w of the point's shadow on the plane; a point light scales it down towards the light
    const glm::dvec4 share = (glm::dvec4(0, 0, 0, 1) - ground * (light.w / height)) * glm::inverse(to_map);
    const glm::dvec2 swept = depths_within(to_map, casters,
                                           {{1, 0, 0, edge},
                                            {-1, 0, 0, edge},
                                            {0, 1, 0, edge},
                                            {0, -1, 0, edge},
                                            glm::dvec4(0, 0, 0, 1) - share * least,
                                            share * greatest - glm::dvec4(0, 0, 0, 1)});
    // Casters below the plane shade none of it. The box goes on there for other receivers alone.
    extent box{glm::dvec3(-edge, -edge, (glm::min)(0.0, swept.x)),
               glm::dvec3(edge, edge, glm::clamp(swept.y, 0.0, 1.0))};
    const double deep = (glm::max)(double(fit.margin), 0x1p-8);
    box.low.z -= deep, box.high.z += deep;
    const auto warped = laid_around(seen, to_map, box, least, greatest, fit, function);
    require(warped.has_value(), function, "plane and camera", "such that the map is neither too large nor too small",
            plane);
    return holds(warped->light, seen) ? warped : std::nullopt;
}

}  // namespace detail

/// Map of a directional light in which a plane lies as the camera sees it.
///
/// A map with k texels per pixel across the screen has them everywhere on the plane, under every light. It contains
/// the casters of the visible part of the plane. Receivers off the plane are in the map where their shadow on the plane
/// is, with fewer texels. The caller decides about other receivers: project_coordinate finds w <= 0, and inside_cascade
/// finds the rest.
///
/// @param fit     camera, light and casters. The plane replaces its receivers
/// @param plane   dot(plane, (p, 1)) = 0, with a normal of any length > 0. The light may come from either side
/// @return        warped light. Nothing if the camera does not see the plane, or if camera or light lie in it (1e-6).
///                Nothing too where T is too coarse, far from the origin: rounding must not move the visible part
///                of the plane out of the map by more than 1/16 of its half size.
///                The map is of no use for light that barely reaches the plane. Depth is the height over the plane
///                divided by w, and hardly grows along such light
/// @throws std::invalid_argument  zero or non-finite direction; an invalid camera, plane or box of casters; receivers
///                                missing; a margin out of range; clip unset; matrices that would not be finite
/// @formula       x, y and w of the camera after (N.L) I - L N^T, depth - N.p
template <real T = float>
[[nodiscard]] std::optional<warped_light<T>> fit_plane_optimal(const warp_fit<T>& fit, const glm::vec<4, T>& plane) {
    constexpr auto function = "fit_plane_optimal";
    const warp_fit<T> whole = detail::completed(fit, function);
    const glm::dmat4 view = detail::light_frame(detail::view_of(fit, function), fit.clip.hand);
    const glm::dvec4 light(-view[0][2], -view[1][2], -view[2][2], 0.0);
    return detail::plane_optimal_of(light, whole, fit.casters ? polyhedron(*fit.casters) : polyhedron(), plane,
                                    function);
}

/// Map of a point light in which a plane lies as the camera sees it.
/// @param fit   its direction is the light's axis
/// @param plane as for a directional light
/// @param from  position of the light, and its near plane
/// @throws std::invalid_argument  receivers that do not all lie along the axis beyond z_near; z_near not above 0;
///                                errors of fit_plane_optimal above
template <real T>
[[nodiscard]] std::optional<warped_light<T>> fit_plane_optimal(const warp_fit<T>& fit, const glm::vec<4, T>& plane,
                                                               const light_position<T>& from) {
    constexpr auto function = "fit_plane_optimal";
    const warp_fit<T> whole = detail::completed(fit, from, function);
    const detail::axis_view own = detail::view_of(from, whole, function);
    return detail::plane_optimal_of(glm::dvec4(glm::dvec3(from.position), 1.0), whole, own.casters, plane, function);
}

}  // namespace umbrage
