// SPDX-License-Identifier: MIT
//
// Point light: six light spaces, for the faces of a cube texture or the tiles of an atlas.
//
//     auto faces = umbrage::make_point_light<float>({.position = p, .map_size = 512, .border = 2, .clip = clip});
//     glm::vec3 at = umbrage::cube_coordinate(world - p);
//     glm::vec2 texel = glm::vec2(at) * float(512 - 2 * 2) + 2.0f;  // in the map of faces[int(at.z)]
//
// A border extends each map beyond its face, so that filters need no other face. std::ceil(filter.reach()) texels are
// enough. Between faces the edge of a shadow moves by at most one texel. A cube texture has no border: set it to 0.
// Depth is that of a perspective projection per face, at `cube_view_z`. The depth pass must write distances
// (`distance_depth`) itself.
// Also called: omnidirectional shadows, point light shadows (make_point_light).
// See also: dual_paraboloid.hpp (two maps), tetrahedron_light.hpp (four).
#pragma once

#include <array>
#include <cstddef>

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/cube_map.hpp>

namespace umbrage {

/// Point light with the six maps of a cube.
template <real T = float>
struct point_light {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);   ///< near plane along each face's axis, world units, > 0. With forward depth at least
                         ///< 56 2^-24 z_far (3.4e-6)
    T z_far = T(100);    ///< far plane, > z_near; infinite: no far plane
    int map_size = 512;  ///< size of a face, in texels, > 2 border
    int border = 2;      ///< texels beyond each edge of the face, inside map_size: the filter's reach or more. 2 is
                         ///< enough for tent<3>. For a cube texture 0
    clip_space clip{};   ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Light spaces along cube_faces, with perspective projections of 90 degrees plus the border.
///
/// The first texel is at (0, 0) of cube_coordinate in every clip space. The projection is a mirror if clip is either
/// left-handed or has its first row at the top, but not both. Front faces then have the opposite winding.
/// @throws std::invalid_argument  map_size not above 2 border; planes out of order, or z_near below 56 2^-24 z_far
///                                with forward depth; clip unset; matrices that would not be finite
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 6> make_point_light(const point_light<T>& light) {
    constexpr auto function = "make_point_light";
    detail::require(light.border >= 0, function, "border", "0 or more", light.border);
    detail::require(light.map_size / 2 >= light.border && light.map_size > 2 * light.border, function, "map_size",
                    "above twice the border", light.map_size);
    const T extent = T(light.map_size) / T(light.map_size - 2 * light.border);
    glm::mat<4, 4, T> projection = detail::perspective(extent, extent, light.z_near, light.z_far, light.clip, function);
    detail::require_digits(light.z_near, light.z_far, light.clip, function);
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
