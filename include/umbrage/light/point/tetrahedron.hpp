// SPDX-License-Identifier: MIT
//
// Four triangular maps around a point light, the sides of a square that its diagonals cut: which of them a direction
// meets, and where. Straight edges stay straight.
//
//     glm::vec3 at = umbrage::tetrahedron_coordinate(world - light);  // (s, t, face)
//     glm::vec2 texel = umbrage::tetrahedron_texel(at, 1024.0f, 2.0f);
//     float depth = umbrage::depth_from_view_z(umbrage::tetrahedron_view_z(world - light), z_near, z_far);
//
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Which way a face looks: (0, -h, k), (0, -h, -k), (k, h, 0), (-k, h, 0), h = sqrt(1/3), k = sqrt(2/3). Its corners
/// are where the other three look away from.
/// @param face   0 .. 3
template <real T>
[[nodiscard]] glm::vec<3, T> tetrahedron_normal(int face) {
    const T h = std::sqrt(T(1) / T(3)), k = std::sqrt(T(2) / T(3)), side = face % 2 == 0 ? k : -k;
    return face < 2 ? glm::vec<3, T>(T(0), -h, side) : glm::vec<3, T>(side, h, T(0));
}

/// The face that a direction meets: the one that looks that way most.
/// @param direction   of any length
/// @return            0 .. 3; some for NaN
/// @formula           of the first two where |z| - |x| >= sqrt(2) y, of either two by the sign of z or x
/// @exactness         B, n = 1
/// @cite              Liao: Shadow Mapping for Omnidirectional Light Using Tetrahedron Mapping, GPU Pro, 2010
template <real T>
[[nodiscard]] constexpr int tetrahedron_face(glm::vec<3, T> direction) {
    const T x = direction.x < T(0) ? -direction.x : direction.x, z = direction.z < T(0) ? -direction.z : direction.z;
    const T beside = z - x, up = direction.y * T(1.41421356237309504880);
    const bool below = !is_nan(beside) && !is_nan(up) && beside >= up;
    return below ? (direction.z < T(0) ? 1 : 0) : (direction.x < T(0) ? 3 : 2);
}

/// A direction in a face's own axes.
/// @param face   0 .. 3
/// @return       (aside, up, away), see tetrahedron_plane
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_face_point(int face, glm::vec<3, T> d) {
    if (face < 2) return face == 0 ? glm::vec<3, T>(-d.x, d.y, d.z) : glm::vec<3, T>(d.x, d.y, -d.z);
    return face == 2 ? glm::vec<3, T>(-d.z, -d.y, d.x) : glm::vec<3, T>(d.z, -d.y, -d.x);
}

/// A direction in the axes of the face that it meets.
/// @return        (aside, up, away): along the face's base, to the right for who looks along the face with its apex
///                above; up in the world, of faces 2 and 3 down; away from the other face of the same two, >= 0
/// @exactness     B, n = 1: S of tetrahedron_face, then selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_plane(glm::vec<3, T> direction) {
    return tetrahedron_face_point(tetrahedron_face(direction), direction);
}

/// Distance to a direction's end along the normal of the face that it meets: what per-face depths are made of.
/// @formula       sqrt(2/3) away - sqrt(1/3) up
/// @exactness     B, n = 3
template <real T>
[[nodiscard]] constexpr T tetrahedron_view_z(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    return p.z * T(0.81649658092772603273) + p.y * T(-0.57735026918962576451);
}

/// Where on its face a direction meets the tetrahedron.
/// @param direction   of any length; zero and NaN give coordinates that are NaN, which every filter takes as lit
/// @return            (s, t, face): t from 0 at the base to 1 at the apex, |s| <= 1 - t
/// @formula           s = aside / d, t = away / d, d = 2 away - sqrt(2) up
/// @exactness         C, n = 6: divisions
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_coordinate(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    const T d = p.z * T(2) + p.y * T(-1.41421356237309504880);
    return {p.x / d, p.z / d, T(tetrahedron_face(direction))};
}

/// A vector of face 0's side of the map on another face's: turned by quarters.
/// @param face   0 .. 3
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> tetrahedron_turned(int face, glm::vec<2, T> v) {
    if (face < 2) return face == 0 ? v : glm::vec<2, T>(-v.x, -v.y);
    return face == 2 ? glm::vec<2, T>(-v.y, v.x) : glm::vec<2, T>(v.y, -v.x);
}

/// Where in a square map that is.
/// @param at       tetrahedron_coordinate;   size  of the map, in texels;   border  as make_tetrahedron_light's
/// @return         texels; face 0's base is the first row, 1's the last, 2's the last column, 3's the first
/// @formula        of face 0 (h + (h - 3 b) s, b + (h - 3 b) t), h = size / 2: b texels aside in x and in y are 3 b on
///                 a base from its corners and 2 b at the apex; the other faces' turned by quarters
/// @exactness      B, n = 9: S = h + (h + 3 b) |s|, 2 h + b + (h + 3 b) t
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> tetrahedron_texel(glm::vec<3, T> at, T size, T border) {
    const T half = size * T(0.5), scale = half - border * T(3);
    const T x = at.x * scale, y = at.y * scale + (border - half);
    const int face = at.z < T(1.5) ? (at.z < T(0.5) ? 0 : 1) : (at.z < T(2.5) ? 2 : 3);
    const glm::vec<2, T> off = tetrahedron_turned(face, glm::vec<2, T>(x, y));
    return {half + off.x, half + off.y};
}

/// The face whose triangle a texel lies in: what a depth pass of another face must leave alone.
/// @param texel   whole numbers;   size  of the map, in texels, below 2^22
/// @return        0 .. 3; texels on a diagonal are faces 0's and 1's
/// @exactness     A: whole numbers
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
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
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
    .summary = "a direction in the axes of a tetrahedron's face",
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
    .summary = "a direction in its tetrahedron face's axes",
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
    .summary = "distance along the normal of the tetrahedron's face that a direction meets",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
UMBRAGE_HIGHP float umbrage_tetrahedron_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
)GLSL",
};

inline constexpr snippet tetrahedron_coordinate{
    .name = "tetrahedron_coordinate",
    .summary = "face of a tetrahedron, and where on it, that a direction meets",
    .exactness = tier::c,
    .operations = 6,
    .needs = list<&tetrahedron_face, &tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = p.z * 2.0 + p.y * -1.414213562;
    return vec3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
)GLSL",
};

inline constexpr snippet tetrahedron_turned{
    .name = "tetrahedron_turned",
    .summary = "a vector of a tetrahedron's first face on another face's side of the map",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_turned: a vector of face 0's side of the map on that of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_turned(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 v) {
    UMBRAGE_HIGHP vec2 z = face < 0.5 ? v : vec2(-v.x, -v.y);
    UMBRAGE_HIGHP vec2 x = face < 2.5 ? vec2(-v.y, v.x) : vec2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_texel{
    .name = "tetrahedron_texel",
    .summary = "a point of a tetrahedron's face in the map",
    .exactness = tier::b,
    .operations = 9,
    .needs = list<&tetrahedron_turned>,
    .source = R"GLSL(
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
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
    .summary = "face of a tetrahedron that a texel belongs to",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
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
