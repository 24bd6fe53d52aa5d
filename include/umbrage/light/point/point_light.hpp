// SPDX-License-Identifier: MIT
//
// A point light's six spaces, for a cube texture's faces or an atlas's tiles.
//
//     auto faces = umbrage::make_point_light<float>({.position = p, .map_size = 512, .border = 2, .clip = clip});
//     glm::vec3 at = umbrage::cube_coordinate(world - p);
//     glm::vec2 texel = glm::vec2(at) * float(512 - 2 * 2) + 2.0f;  // in the map of faces[int(at.z)]
//
// A border of texels sees past the face's edges: filters then need no other face, and where a shadow passes from one
// face to the next its edge moves by a texel at most. As many as std::ceil(filter.reach() + 1) will do. Depths are per
// face, those of a perspective projection at cube_view_z; distances, distance_depth, a depth pass must write.
#pragma once

#include <array>
#include <cstddef>

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/cube_map.hpp>

namespace umbrage {

template <real T = float>
struct point_light {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);   ///< > 0, world units along each face's axis
    T z_far = T(100);    ///< > z_near; infinite: no far plane
    int map_size = 512;  ///< of a face, in texels, > 2 border
    int border = 0;      ///< texels beyond each edge of the face, within map_size
    clip_space clip{};   ///< required: your API's or engine's, see clip_space.hpp
};

/// Views along cube_faces and perspective projections of 90 degrees and the border, whose first texel is (0, 0) of
/// cube_coordinate in every convention. Where clip is left-handed or has its first row on top, one of them, the
/// projection is a mirror: front faces go the other way round.
/// @throws std::invalid_argument  no texels within the border, planes out of order, and what gives matrices that are
///                                not finite
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 6> make_point_light(const point_light<T>& light) {
    constexpr auto function = "make_point_light";
    detail::require(light.border >= 0, function, "border", "0 or more", light.border);
    detail::require(light.map_size / 2 >= light.border && light.map_size > 2 * light.border, function, "map_size",
                    "above twice the border", light.map_size);
    const T extent = T(light.map_size) / T(light.map_size - 2 * light.border);
    glm::mat<4, 4, T> projection = detail::perspective(extent, extent, light.z_near, light.z_far, light.clip, function);
    if (light.clip.hand == handedness::left) projection[0][0] = -projection[0][0];
    if (light.clip.origin == texture_origin::top) projection[1][1] = -projection[1][1];
    std::array<light_space<T>, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto view = detail::look_along(light.position, glm::vec<3, T>(cube_faces[i].forward),
                                             glm::vec<3, T>(cube_faces[i].up), light.clip.hand, function, "position");
        faces[i] = detail::checked<T>({view, projection, light.clip}, function, "position, z_near and z_far");
    }
    return faces;
}

}  // namespace umbrage
