// SPDX-License-Identifier: MIT
//
// Culling of instances against a shadow map. The map of a cascade covers a small part of the world, and most casters
// are outside.
//
//     const umbrage::bounding_box<float> box = umbrage::bounds_of(tree);  // once
//     for (const auto& c : cascades) {
//         const glm::mat4 world_to_clip = c.light.projection * c.light.view;
//         umbrage::rasterize_depth(map, tree, umbrage::instances_in_map(box, trees, world_to_clip, clip),
//                                  world_to_clip, clip);
//     }
//
// Also called: caster culling, frustum culling of casters (instances_in_map).
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
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/light/bounds.hpp>

namespace umbrage {

/// Bounding box of a mesh's positions.
/// @param mesh   positions that are not finite are skipped, as the depth pass skips their triangles
/// @edge         no position: low above high. Nothing is then drawn, and corners() refuses the box
template <class = detail::on_use>
[[nodiscard]] bounding_box<float> bounds_of(const mesh_view& mesh) {
    bounding_box<float> box{glm::vec3(detail::highest<float>), glm::vec3(-detail::highest<float>)};
    for (const glm::vec3& p : mesh.positions)
        if (detail::all_finite(p)) box.low = (glm::min)(box.low, p), box.high = (glm::max)(box.high, p);
    return box;
}

namespace detail {

/// True when a body within a box may mark a texel. Other parameters as for umbrage::may_mark.
/// @param middle         center of the box
/// @param half           half size of the box
/// @param reach          dvec3 normal -> extent of the body from its center along the normal, times its length
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
    // The body is outside if a multiple of w plus a multiple of a row is below 0 for all of it.
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

/// True when a mesh within the bounds may mark a texel of a map.
///
/// False only if all of it is outside of one plane: a side, the far plane, the eye's, or a near plane that clips. A
/// near plane that clamps keeps casters between it and the light.
/// @param bounds    in the mesh's space
/// @param to_clip   model_to_clip, or any matrix with which the mesh is drawn
/// @param clip      clip space that the matrix leads to
/// @param at_near   as for the depth pass
/// @edge            low above high, or a radius below 0: false, nothing is there. Bounds not finite: true. to_clip not
///                  finite: false, nothing is drawn
/// @exactness       conservative: with a margin of 2^-20 of the sums that a shader's floats round
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

/// Instances that may mark a map, in their order. The depth pass of these has the same bits as that of all.
/// @param bounds          box or sphere around the mesh
/// @param instances       model to world, one matrix each
/// @param world_to_clip   projection * view
/// Other parameters as for may_mark.
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
