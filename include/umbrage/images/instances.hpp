// SPDX-License-Identifier: MIT
//
// Which instances of a mesh a map has to draw: a cascade's holds a small part of the world, and most casters lie beside
// it.
//
//     const umbrage::bounding_box<float> box = umbrage::bounds_of(tree);  // once
//     for (const auto& c : cascades) {
//         const glm::mat4 world_to_clip = c.light.projection * c.light.view;
//         umbrage::rasterize_depth(map, tree, umbrage::instances_in_map(box, trees, world_to_clip, clip),
//                                  world_to_clip, clip);
//     }
//
#pragma once

#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/images/mesh.hpp>
#include <umbrage/light/bounds.hpp>

namespace umbrage {

/// The box around a mesh's positions.
/// @param mesh   positions that are not finite do not count, as the depth pass leaves their triangles out
/// @return       low above high where there is none: nothing is then drawn, and corners() refuses it
template <class = detail::on_use>
[[nodiscard]] bounding_box<float> bounds_of(const mesh_view& mesh) {
    bounding_box<float> box{glm::vec3(detail::highest<float>), glm::vec3(-detail::highest<float>)};
    for (const glm::vec3& p : mesh.positions)
        if (detail::all_finite(p)) box.low = detail::lesser(box.low, p), box.high = detail::greater(box.high, p);
    return box;
}

namespace detail {

/// Whether a body, within a box around its middle, may mark a texel; the rest as for umbrage::may_mark.
/// @param reach   dvec3 normal -> how far the body goes from its middle along it, times its length
template <class Reach>
[[nodiscard]] bool may_mark(const glm::dvec3& middle, const glm::dvec3& half, const Reach& reach,
                            const glm::mat4& to_clip, clip_space clip, near_plane at_near) {
    require_given(clip, "may_mark");
    if (!all_finite(to_clip)) return false;
    if (!all_finite(middle) || !all_finite(half)) return true;
    const glm::dmat4 rows = glm::transpose(glm::dmat4(to_clip));
    const auto magnitude = [&](const glm::dvec4& row) {
        return glm::dot(glm::abs(glm::dvec3(row)), glm::abs(middle) + half) + glm::abs(row.w);
    };
    const double of_w = magnitude(rows[3]);
    // All of it where a multiple of w and another of a row sum to less than 0.
    const auto beyond = [&](double w, glm::length_t row, double sign) {
        const glm::dvec4 plane = rows[3] * w + rows[row] * sign;
        const double farthest = glm::dot(glm::dvec3(plane), middle) + plane.w + reach(glm::dvec3(plane));
        return farthest < -0x1p-20 * (of_w + magnitude(rows[row]));
    };
    const bool forward = clip.direction == depth_direction::forward, clips = at_near == near_plane::clips;
    const double low = clip.range == depth_range::zero_to_one ? 0.0 : 1.0;  // z >= 0, or w + z >= 0
    return !(beyond(1, 0, 1) || beyond(1, 0, -1) || beyond(1, 1, 1) || beyond(1, 1, -1) || beyond(1, 3, 0) ||
             ((clips || !forward) && beyond(low, 2, 1)) || ((clips || forward) && beyond(1, 2, -1)));
}

}  // namespace detail

/// Whether a mesh within bounds may mark a texel of a map: false only where all of it lies beyond one side, beyond the
/// far plane, behind the eye, or, if that clips, before the near plane. Where the near plane clamps, casters between
/// it and the light stay.
///
/// @param bounds    in the mesh's own space; low above high, or a radius below 0: there is nothing, false; not finite:
///                  anything may be there, true
/// @param to_clip   model_to_clip, or any matrix that the mesh is drawn with; not finite: nothing is drawn, false
/// @param at_near   as the depth pass has it
/// @exactness       conservative: with 2^-20 to spare of the sums that a shader's floats round
template <class = detail::on_use>
[[nodiscard]] bool may_mark(const bounding_box<float>& bounds, const glm::mat4& to_clip, clip_space clip,
                            near_plane at_near = near_plane::clips) {
    if (glm::any(glm::greaterThan(bounds.low, bounds.high))) return false;
    const glm::dvec3 low(bounds.low), high(bounds.high), half = (high - low) * 0.5;
    const auto reach = [&](const glm::dvec3& normal) { return glm::dot(glm::abs(normal), half); };
    return detail::may_mark((low + high) * 0.5, half, reach, to_clip, clip, at_near);
}
template <class = detail::on_use>
[[nodiscard]] bool may_mark(const bounding_sphere<float>& bounds, const glm::mat4& to_clip, clip_space clip,
                            near_plane at_near = near_plane::clips) {
    if (bounds.radius < 0.0f) return false;
    const auto radius = static_cast<double>(bounds.radius);
    const auto reach = [&](const glm::dvec3& normal) { return glm::length(normal) * radius; };
    return detail::may_mark(glm::dvec3(bounds.center), glm::dvec3(radius), reach, to_clip, clip, at_near);
}

/// The instances that may mark a map, in their order: the depth pass of these has the bits of that of all.
/// @param bounds          of the mesh: box or sphere
/// @param instances       model to world, a matrix each
/// @param world_to_clip   projection * view
/// The rest as for may_mark.
template <class Bounds>
[[nodiscard]] std::vector<glm::mat4> instances_in_map(const Bounds& bounds, std::span<const glm::mat4> instances,
                                                      const glm::mat4& world_to_clip, clip_space clip,
                                                      near_plane at_near = near_plane::clips) {
    std::vector<glm::mat4> kept;
    for (const glm::mat4& model : instances)
        if (may_mark(bounds, model_to_clip(world_to_clip, model), clip, at_near)) kept.push_back(model);
    return kept;
}

}  // namespace umbrage
