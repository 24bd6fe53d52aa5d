// SPDX-License-Identifier: MIT
//
// Point light with a tetrahedron shadow map: four light spaces, one per face, for the triangles of one map.
//
//     auto faces = umbrage::make_tetrahedron_light<float>(
//         {.position = p, .map_size = 1024, .border = 2, .clip = clip});
//     umbrage::rasterize_tetrahedron(map.view(), mesh, faces);  // draw/tetrahedron_pass.hpp
//     glm::vec2 texel = umbrage::tetrahedron_texel(umbrage::tetrahedron_coordinate(world - p), 1024.0f, 2.0f);
//
// Triangles share rectangles, so a face's depth pass must leave the texels of other faces unchanged. Discard in a
// fragment shader:
//
//     if (umbrage_tetrahedron_face_of(floor(gl_FragCoord.xy), 1024.0) != face) discard;
//
// Or clip in a vertex shader. If the first row is at NDC y = -1, the clip distances of face 0 are -y - x and -y + x of
// gl_Position. For the other faces rotate them by quarter turns.
//
// A border along the sides of a triangle extends it beyond its face, so that filters need no other face: see
// point_light.hpp.
#pragma once

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/mat2x3.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/point/tetrahedron.hpp>

namespace umbrage {

/// Point light with the four triangular maps of a tetrahedron.
template <real T = float>
struct tetrahedron_light {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);    ///< near plane along each face's normal, world units, > 0: three times as far at corners.
                          ///< With forward depth at least 56 2^-24 z_far (3.4e-6)
    T z_far = T(100);     ///< far plane, > z_near; infinite: no far plane
    int map_size = 1024;  ///< size of the square, in texels, > 6 border
    int border = 2;       ///< texels along each side of a triangle, inside it: the filter's reach or more. 2 is enough
                          ///< for tent<3>
    clip_space clip{};    ///< required: clip space of your API or engine, see clip_space.hpp
};

/// Corners of a face's triangle in the map. Each is opposite to one of the other three faces, whose order they have.
template <real T>
using tetrahedron_tile = std::array<glm::vec<2, T>, 3>;

/// Triangles of tetrahedron_texel without a border: the four sides of a square with its center.
template <real T = float>
[[nodiscard]] std::array<tetrahedron_tile<T>, 4> tetrahedron_tiles(T size) {
    const glm::vec<2, T> low(0), high(size), middle(size / T(2)), right(size, T(0)), left(T(0), size);
    return {{{middle, right, low}, {middle, high, left}, {high, right, middle}, {left, low, middle}}};
}

/// Triangle without a border of texels, in x and in y, along each of its sides.
/// @return        triangle; turned inside out if nothing is left
template <real T>
[[nodiscard]] tetrahedron_tile<T> without_border(const tetrahedron_tile<T>& t, T border) {
    const auto cross = [](glm::vec<2, T> a, glm::vec<2, T> b) { return a.x * b.y - a.y * b.x; };
    const T turn = cross(t[1] - t[0], t[2] - t[0]) < T(0) ? T(-1) : T(1);
    std::array<glm::vec<3, T>, 3> sides;  // a point p on a side has (p, 1) . side = 0
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec<2, T> along = (t[(i + 1) % 3] - t[i]) * turn, normal(-along.y, along.x);
        sides[i] = {normal, -glm::dot(normal, t[i]) - border * (glm::abs(normal.x) + glm::abs(normal.y))};
    }
    tetrahedron_tile<T> inner;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec<3, T> corner = glm::cross(sides[(i + 2) % 3], sides[i]);
        inner[i] = glm::vec<2, T>(corner) / corner.z;
    }
    return inner;
}

/// Light spaces of four faces: a view along each face's normal, and a projection onto its triangle without the border.
///
/// The first texel is at (0, 0) in every clip space. The projection is a mirror if clip is either left-handed or has
/// its first row at the top, but not both.
/// @param light   position, range and map size
/// @param tiles   any four triangles, in texels. For lookups use the texture_matrix of faces[tetrahedron_face(...)]
/// @throws std::invalid_argument  a border that leaves nothing of a triangle; planes out of order,
///                                or z_near below 56 2^-24 z_far with forward depth; clip
///                                unset; matrices that would not be finite
/// @formula       a direction p is at sum of b_j T_j / sum of b_j, b_j = 3/4 (n_i - n_j) . p
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 4> make_tetrahedron_light(const tetrahedron_light<T>& light,
                                                                   const std::array<tetrahedron_tile<T>, 4>& tiles) {
    constexpr auto function = "make_tetrahedron_light";
    detail::require(light.map_size >= 1, function, "map_size", "above 0", light.map_size);
    detail::require(light.border >= 0, function, "border", "0 or more", light.border);
    const glm::mat<4, 4, T> depths = detail::perspective(T(1), T(1), light.z_near, light.z_far, light.clip, function);
    detail::require_digits(light.z_near, light.z_far, light.clip, function);
    std::array<light_space<T>, 4> faces;
    for (int i = 0; i < 4; ++i) {
        const tetrahedron_tile<T>& whole = tiles[static_cast<std::size_t>(i)];
        const tetrahedron_tile<T> tile = without_border(whole, T(light.border));
        detail::require(glm::dot(tile[1] - tile[0], whole[1] - whole[0]) > T(0), function, "border",
                        "narrow enough to leave some of each triangle", light.border);
        const glm::vec<3, T> normal = tetrahedron_normal<T>(i);
        glm::mat<2, 3, T> rows(T(0));  // rows of x w and y w, with w = normal . p
        for (int j = 0, corner = 0; j < 4; ++j) {
            if (j == i) continue;
            glm::vec<2, T> ndc = tile[static_cast<std::size_t>(corner++)] * (T(2) / T(light.map_size)) - T(1);
            if (light.clip.origin == texture_origin::top) ndc.y = -ndc.y;
            for (glm::length_t k = 0; k < 2; ++k) rows[k] += (normal - tetrahedron_normal<T>(j)) * (ndc[k] / T(4));
        }
        const auto view = detail::look_along(light.position, normal, -tetrahedron_normal<T>(i ^ 1), light.clip.hand,
                                             function, "position");
        glm::mat<4, 4, T> projection = depths;
        for (glm::length_t k = 0; k < 2; ++k) {
            const glm::vec<3, T> row = glm::mat<3, 3, T>(view) * rows[k];
            for (glm::length_t c = 0; c < 3; ++c) projection[c][k] = row[c];
        }
        faces[static_cast<std::size_t>(i)] =
            detail::checked<T>({view, projection, light.clip}, function, "position, z_near and z_far");
    }
    return faces;
}

/// Light spaces of four faces, with the triangles of tetrahedron_texel.
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 4> make_tetrahedron_light(const tetrahedron_light<T>& light) {
    return make_tetrahedron_light(light, tetrahedron_tiles(T(light.map_size)));
}

}  // namespace umbrage
