// SPDX-License-Identifier: MIT
//
// Tetrahedron shadow map: four triangular maps around a point light, which fill a square cut by its diagonals.
// The functions give a direction's face, and the position on it. Straight edges stay straight.
//
//     glm::vec3 at = umbrage::tetrahedron_coordinate(world - light);  // (s, t, face)
//     glm::vec2 texel = umbrage::tetrahedron_texel(at, 1024.0f, 2.0f);
//     float depth = umbrage::depth_from_view_z(umbrage::tetrahedron_view_z(world - light), z_near, z_far);
//
// Also called: tetrahedron shadow map, tetrahedron mapping (tetrahedron_coordinate).
// See also: tetrahedron_light.hpp for the light spaces; cube_map.hpp.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Normal of a face: (0, -h, k), (0, -h, -k), (k, h, 0), (-k, h, 0), h = sqrt(1/3), k = sqrt(2/3).
/// The corners of a face lie opposite to the normals of the other three.
/// @param face   0 to 3
template <real T>
[[nodiscard]] glm::vec<3, T> tetrahedron_normal(int face) {
    const T h = std::sqrt(T(1) / T(3)), k = std::sqrt(T(2) / T(3)), side = face % 2 == 0 ? k : -k;
    return face < 2 ? glm::vec<3, T>(T(0), -h, side) : glm::vec<3, T>(side, h, T(0));
}

/// Face that a direction meets: the one whose normal is closest to it.
/// @param direction   any length
/// @return            0 to 3
/// @edge              NaN: some face
/// @formula           one of the first two if |z| - |x| >= sqrt(2) y, else one of the last two; by the sign of z or x
/// @exactness         B, n = 1
/// @cite              Liao: Shadow Mapping for Omnidirectional Light Using Tetrahedron Mapping, GPU Pro, 2010
template <real T>
[[nodiscard]] constexpr int tetrahedron_face(glm::vec<3, T> direction) {
    const T x = direction.x < T(0) ? -direction.x : direction.x, z = direction.z < T(0) ? -direction.z : direction.z;
    const T beside = z - x, up = direction.y * T(1.41421356237309504880);
    const bool below = !is_nan(beside) && !is_nan(up) && beside >= up;
    return below ? (direction.z < T(0) ? 1 : 0) : (direction.x < T(0) ? 3 : 2);
}

/// Direction in a face's own axes.
/// @param face   0 to 3
/// @param d      direction from the light, any length
/// @return       (aside, up, away), see tetrahedron_plane
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_face_point(int face, glm::vec<3, T> d) {
    if (face < 2) return face == 0 ? glm::vec<3, T>(-d.x, d.y, d.z) : glm::vec<3, T>(d.x, d.y, -d.z);
    return face == 2 ? glm::vec<3, T>(-d.z, -d.y, d.x) : glm::vec<3, T>(d.z, -d.y, -d.x);
}

/// Direction in the axes of the face that it meets.
/// @return        (aside, up, away). aside: along the face's base, to the right for a view along the face with its apex
///                at the top. up: up in the world, down for faces 2 and 3. away: from the other face of the same pair,
///                >= 0
/// @exactness     B, n = 1: S of tetrahedron_face, then selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_plane(glm::vec<3, T> direction) {
    return tetrahedron_face_point(tetrahedron_face(direction), direction);
}

/// Distance to a direction's end along its face's normal, the input of per-face depths.
/// @formula       sqrt(2/3) away - sqrt(1/3) up
/// @exactness     B, n = 3
template <real T>
[[nodiscard]] constexpr T tetrahedron_view_z(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    return p.z * T(0.81649658092772603273) + p.y * T(-0.57735026918962576451);
}

/// Position on its face where a direction meets the tetrahedron.
/// @param direction   any length
/// @return            (s, t, face): t from 0 at the base to 1 at the apex, |s| <= 1 - t
/// @edge              zero or NaN: NaN coordinates, which every filter takes as lit
/// @formula           s = aside / d, t = away / d, d = 2 away - sqrt(2) up
/// @exactness         C, n = 6: divisions
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_coordinate(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    const T d = p.z * T(2) + p.y * T(-1.41421356237309504880);
    return {p.x / d, p.z / d, T(tetrahedron_face(direction))};
}

/// Vector from face 0's part of the map, rotated to another face's part by quarter turns.
/// @param face   0 to 3
/// @param v      vector in face 0's part of the map
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> tetrahedron_turned(int face, glm::vec<2, T> v) {
    if (face < 2) return face == 0 ? v : glm::vec<2, T>(-v.x, -v.y);
    return face == 2 ? glm::vec<2, T>(-v.y, v.x) : glm::vec<2, T>(v.y, -v.x);
}

/// Position in the square map of a position on a face.
/// @param at       result of tetrahedron_coordinate
/// @param size     size of the map, in texels
/// @param border   border of make_tetrahedron_light, in texels
/// @return         position in texels. The bases of faces 0 and 1 are the first and the last row. The bases of faces 2
///                 and 3 are the last and the first column
/// @formula        for face 0 (h + (h - 3 b) s, b + (h - 3 b) t), h = size / 2. A border b in x and in y takes 3 b of a
///                 base at its corners, and 2 b at the apex. Other faces are rotated by quarter turns
/// @exactness      B, n = 9: S = h + (h + 3 b) |s|, 2 h + b + (h + 3 b) t
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> tetrahedron_texel(glm::vec<3, T> at, T size, T border) {
    const T half = size * T(0.5), scale = half - border * T(3);
    const T x = at.x * scale, y = at.y * scale + (border - half);
    const int face = at.z < T(1.5) ? (at.z < T(0.5) ? 0 : 1) : (at.z < T(2.5) ? 2 : 3);
    const glm::vec<2, T> off = tetrahedron_turned(face, glm::vec<2, T>(x, y));
    return {half + off.x, half + off.y};
}

/// Face whose triangle contains a texel. Depth passes of other faces must leave the texel unchanged.
/// @param texel   texel index, integers
/// @param size    size of the map, in texels, below 2^22
/// @return        0 to 3; texels on a diagonal belong to faces 0 and 1
/// @exactness     A: integers
template <real T>
[[nodiscard]] constexpr int tetrahedron_face_of(glm::vec<2, T> texel, T size) {
    const T u = texel.x * T(2) + T(1) - size, v = texel.y * T(2) + T(1) - size;
    const bool in_column = (v < T(0) ? -v : v) >= (u < T(0) ? -u : u);
    return in_column ? (v < T(0) ? 0 : 1) : (u < T(0) ? 3 : 2);
}

namespace glsl {

inline constexpr snippet tetrahedron_face{
    .name = "tetrahedron_face",
    .summary = "face of a tetrahedron that a direction meets",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
UMBRAGE_HIGHP float umbrage_tetrahedron_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside = abs(direction.z) - abs(direction.x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float up = direction.y * 1.414213562;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_face_point{
    .name = "tetrahedron_face_point",
    .summary = "direction in the axes of a tetrahedron's face",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 d) {
    UMBRAGE_HIGHP vec3 z = face < 0.5 ? vec3(-d.x, d.y, d.z) : vec3(d.x, d.y, -d.z);
    UMBRAGE_HIGHP vec3 x = face < 2.5 ? vec3(-d.z, -d.y, d.x) : vec3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_plane{
    .name = "tetrahedron_plane",
    .summary = "direction in the axes of its tetrahedron face",
    .exactness = tier::b,
    .operations = 1,
    .needs = list<&tetrahedron_face, &tetrahedron_face_point>,
    .source = R"GLSL(
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_plane(UMBRAGE_HIGHP vec3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
)GLSL",
};

inline constexpr snippet tetrahedron_view_z{
    .name = "tetrahedron_view_z",
    .summary = "distance along the normal of a direction's face",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
UMBRAGE_HIGHP float umbrage_tetrahedron_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
)GLSL",
};

inline constexpr snippet tetrahedron_coordinate{
    .name = "tetrahedron_coordinate",
    .summary = "tetrahedron face of a direction, and the position on it",
    .exactness = tier::c,
    .operations = 6,
    .needs = list<&tetrahedron_face, &tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction
//   s  -1.0 to 1.0 along the base
//   t  0.0 at the base to 1.0 at the apex
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = p.z * 2.0 + p.y * -1.414213562;
    return vec3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
)GLSL",
};

inline constexpr snippet tetrahedron_turned{
    .name = "tetrahedron_turned",
    .summary = "vector rotated from face 0's part of the map to another's",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_turned(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 v) {
    UMBRAGE_HIGHP vec2 z = face < 0.5 ? v : vec2(-v.x, -v.y);
    UMBRAGE_HIGHP vec2 x = face < 2.5 ? vec2(-v.y, v.x) : vec2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_texel{
    .name = "tetrahedron_texel",
    .summary = "position in the map of a point on a tetrahedron's face",
    .exactness = tier::b,
    .operations = 9,
    .needs = list<&tetrahedron_turned>,
    .source = R"GLSL(
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_texel(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP float size,
                                             UMBRAGE_HIGHP float border) {
    UMBRAGE_HIGHP float half_size = size * 0.5;
    UMBRAGE_HIGHP float scale = half_size - border * 3.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = at.x * scale;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = at.y * scale + (border - half_size);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 texel = umbrage_tetrahedron_turned(at.z, vec2(x, y)) + half_size;
    return texel;
}
)GLSL",
};

inline constexpr snippet tetrahedron_face_of{
    .name = "tetrahedron_face_of",
    .summary = "face of a tetrahedron that contains a texel",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
UMBRAGE_HIGHP float umbrage_tetrahedron_face_of(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 off = texel * 2.0 + (1.0 - size);
    UMBRAGE_HIGHP float column = off.y < 0.0 ? 0.0 : 1.0;
    UMBRAGE_HIGHP float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
)GLSL",
};

inline constexpr const snippet* tetrahedron_snippets[]{
    &tetrahedron_face,       &tetrahedron_face_point, &tetrahedron_plane, &tetrahedron_view_z,
    &tetrahedron_coordinate, &tetrahedron_turned,     &tetrahedron_texel, &tetrahedron_face_of};

}  // namespace glsl
}  // namespace umbrage
