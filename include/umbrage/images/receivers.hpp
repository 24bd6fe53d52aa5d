// SPDX-License-Identifier: MIT
//
// Receivers of a whole image, in the three forms that `visibility()` takes.
//   image of vec3     x and y in texels of the map, z depth with the bias already applied
//   receiver_planes   the same as three images of floats
//   depth_receivers   the depth image that a camera rendered
//
//     umbrage::depth_receivers seen{depth, umbrage::receiver_matrix(clip_to_world, to_texels, size, clip), bias};
//
#pragma once

#include <concepts>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// Receivers as three images of the same size: x and y in texels of the map, depth with the bias already applied.
struct receiver_planes {
    image_view<const float> x, y, depth;
};

/// Receivers with their planes, as five images of one size.
struct sloped_receivers {
    receiver_planes at;                        ///< x and y in texels of the map, depth with a bias for rounding only
    image_view<const float> slope_x, slope_y;  ///< change of depth per texel: plane_slope
};

/// Receivers as a camera's depth image.
struct depth_receivers {
    image_view<const float> depth;  ///< from the camera's depth pass, in [0, 1]
    glm::mat4 matrix;               ///< from receiver_matrix
    float bias = 0.0f;              ///< in depth of the map, subtracted from each receiver's
};

/// Image of receivers in one of the three forms. plane_visibility.hpp has an overload for sloped_receivers.
template <class T>
concept receiver_image = std::convertible_to<const T&, image_view<const glm::vec3>> ||
    std::same_as<T, receiver_planes> || std::same_as<T, depth_receivers>;

/// Matrix from a camera's depth image to the shadow map.
///
/// @param clip_to_world    inverse of the camera's projection * view
/// @param texture_matrix   world to texels of the map
/// @param size             size of the depth image in texels, each >= 1
/// @param clip             the camera's clip space
/// @return                 maps (texel + 1/2, depth) to the result of shadow_coordinate, times a number that is
///                         positive in front of the camera. The product is computed in double
/// @throws std::invalid_argument  size below 1; a matrix that is not finite
template <class = detail::on_use>
[[nodiscard]] glm::mat4 receiver_matrix(const glm::mat4& clip_to_world, const glm::mat4& texture_matrix,
                                        glm::ivec2 size, clip_space clip) {
    detail::require_given(clip, "receiver_matrix");
    detail::require(size.x >= 1 && size.y >= 1, "receiver_matrix", "size", "above 0", size);
    const double up = clip.origin == texture_origin::bottom ? 1.0 : -1.0;
    glm::dmat4 to_clip(1.0);
    to_clip[0][0] = 2.0 / size.x;
    to_clip[1][1] = up * 2.0 / size.y;
    to_clip[3] = {-1.0, -up, 0.0, 1.0};
    if (clip.range == depth_range::minus_one_to_one) {
        to_clip[2][2] = 2.0;
        to_clip[3][2] = -1.0;
    }
    const glm::mat4 m(glm::dmat4(texture_matrix) * glm::dmat4(clip_to_world) * to_clip);
    detail::require(detail::all_finite(m), "receiver_matrix", "clip_to_world and texture_matrix",
                    "such that their product is finite", m);
    return m;
}

/// Receiver from one texel of a camera's depth image.
/// @formula       project_coordinate(shadow_coordinate(matrix, (texel + 1/2, depth))), minus bias in depth
/// @exactness     C, as project_coordinate
template <class = detail::on_use>
[[nodiscard]] inline glm::vec3 receiver_at(const depth_receivers& seen, glm::ivec2 texel) {
    const glm::vec3 at(static_cast<float>(texel.x) + 0.5f, static_cast<float>(texel.y) + 0.5f, seen.depth[texel]);
    const glm::vec3 p = project_coordinate(shadow_coordinate(seen.matrix, at));
    return {p.x, p.y, p.z - seen.bias};
}

namespace detail {

/// The receivers, those of an image as a view of it.
template <receiver_image Receivers>
[[nodiscard]] decltype(auto) viewed(const Receivers& receivers) {
    if constexpr (std::convertible_to<const Receivers&, image_view<const glm::vec3>>)
        return image_view<const glm::vec3>(receivers);
    else return (receivers);
}

[[nodiscard]] inline glm::ivec2 size_of(const image_view<const glm::vec3>& receivers, const char*) {
    return receivers.size;
}
[[nodiscard]] inline glm::ivec2 size_of(const depth_receivers& receivers, const char*) { return receivers.depth.size; }
[[nodiscard]] inline glm::ivec2 size_of(const receiver_planes& receivers, const char* function) {
    require_size(receivers.x.size, receivers.depth.size, function, "receivers.x.size", "the depths' size");
    require_size(receivers.y.size, receivers.depth.size, function, "receivers.y.size", "the depths' size");
    return receivers.depth.size;
}
[[nodiscard]] inline glm::ivec2 size_of(const sloped_receivers& receivers, const char* function) {
    const glm::ivec2 size = size_of(receivers.at, function);
    require_size(receivers.slope_x.size, size, function, "receivers.slope_x.size", "that of receivers.at");
    require_size(receivers.slope_y.size, size, function, "receivers.slope_y.size", "that of receivers.at");
    return size;
}

}  // namespace detail
}  // namespace umbrage
