// SPDX-License-Identifier: MIT
//
// Cube shadow maps: six square maps around a point light, as the faces of a cube texture or as six tiles of an atlas.
//
//     glm::vec3 at = umbrage::cube_coordinate(world - light);                      // (s, t, face)
//     auto face = atlas.view().region(umbrage::cube_tile(int(at.z), size), {size, size});
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(face), glm::vec2(at) * float(size), depth);
//
// Also called: omnidirectional shadow maps, shadow cubemap (cube_coordinate). See also: point_light.hpp.
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// View direction and up axis of a face's camera, for an NDC with y = -1 in the first row.
struct cube_axes {
    glm::ivec3 forward, up;
};

/// Faces by index: +x, -x, +y, -y, +z, -z. In a right-handed view of 90 degrees along a face, NDC x is 2 s - 1 and y is
/// 2 t - 1: see cube_coordinate.
/// @cite   OpenGL 4.6 specification, table 8.19: selection of cube map images
inline const std::array<cube_axes, 6> cube_faces{{{{1, 0, 0}, {0, -1, 0}},
                                                  {{-1, 0, 0}, {0, -1, 0}},
                                                  {{0, 1, 0}, {0, 0, 1}},
                                                  {{0, -1, 0}, {0, 0, -1}},
                                                  {{0, 0, 1}, {0, -1, 0}},
                                                  {{0, 0, -1}, {0, -1, 0}}}};

/// Face that a direction from the cube's center meets.
/// @param direction   any length. On edges and corners x goes before y, and y before z
/// @return            0 to 5; 4 or 5 if a NaN leaves no largest component
/// @exactness         A: comparisons
template <real T>
[[nodiscard]] constexpr int cube_face(glm::vec<3, T> direction) {
    const auto magnitude = [](T v) { return v < T(0) ? -v : v; };
    const auto at_least = [](T a, T b) { return !is_nan(a) && !is_nan(b) && a >= b; };
    const T x = magnitude(direction.x), y = magnitude(direction.y), z = magnitude(direction.z);
    const int axis = at_least(x, y) ? (at_least(x, z) ? 0 : 2) : (at_least(y, z) ? 1 : 2);
    const T along = direction[static_cast<glm::length_t>(axis)];
    return 2 * axis + (!is_nan(along) && along < T(0) ? 1 : 0);
}

/// Distance to a direction's end along its face's axis, the input of per-face depths.
/// @return            magnitude of the largest component
/// @exactness         A: selects
template <real T>
[[nodiscard]] constexpr T cube_view_z(glm::vec<3, T> direction) {
    const int face = cube_face(direction);
    const T m = direction[static_cast<glm::length_t>(face / 2)];
    return face % 2 ? -m : m;
}

/// Direction in the axes of its face.
/// @return            (sc, tc, face): components across the face's axis
/// @exactness         A: selects
/// @cite              OpenGL 4.6 specification, table 8.19
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_plane(glm::vec<3, T> direction) {
    const int face = cube_face(direction), axis = face / 2;
    const T flip = face % 2 == 0 ? T(1) : T(-1);
    const T sc = axis == 0 ? direction.z * -flip : axis == 1 ? direction.x : direction.x * flip;
    return {sc, axis == 1 ? direction.z * flip : -direction.y, T(face)};
}

/// Point from its coordinates in a face's axes, the inverse of cube_plane.
/// @param face   0 to 5
/// @param p      (sc, tc, cube_view_z)
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_point(T face, glm::vec<3, T> p) {
    if (face < T(0.5)) return {p.z, -p.y, -p.x};
    if (face < T(1.5)) return {-p.z, -p.y, p.x};
    if (face < T(2.5)) return {p.x, p.z, p.y};
    if (face < T(3.5)) return {p.x, -p.z, -p.y};
    if (face < T(4.5)) return {p.x, -p.y, p.z};
    return {-p.x, -p.y, -p.z};
}

/// Point or vector in a face's axes, the inverse of cube_point.
/// @param face   0 to 5
/// @param p      point or vector from the cube's center
/// @return       (sc, tc, distance along the face's axis)
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_face_point(T face, glm::vec<3, T> p) {
    if (face < T(0.5)) return {-p.z, -p.y, p.x};
    if (face < T(1.5)) return {p.z, -p.y, -p.x};
    if (face < T(2.5)) return {p.x, p.z, p.y};
    if (face < T(3.5)) return {p.x, -p.z, -p.y};
    if (face < T(4.5)) return {p.x, -p.y, p.z};
    return {-p.x, -p.y, -p.z};
}

/// Position on its face where a direction meets the cube.
/// @param direction   any length. Zero and NaN give NaN coordinates, which every filter takes as lit
/// @return            (s, t, face): s and t from 0 to 1 over the face; times the face's size, a filter's coordinate
/// @formula           s = (sc + m) / 2m, t = (tc + m) / 2m, with cube_plane's sc and tc and m = cube_view_z
/// @exactness         C, n = 5: divisions
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_coordinate(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = cube_plane(direction);
    const T m = cube_view_z(direction);
    return {(p.x + m) / (m + m), (p.y + m) / (m + m), p.z};
}

/// Direction to a point of a face, the inverse of cube_coordinate.
/// @param face   0 to 5
/// @param st     position from 0 to 1 over the face
/// @return       direction whose largest component is 1 or -1
/// @exactness    B, n = 2, S = 2 st + 1: 2 s - 1 rounds once
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_direction(T face, glm::vec<2, T> st) {
    return cube_point(face, glm::vec<3, T>(st.x * T(2) - T(1), st.y * T(2) - T(1), T(1)));
}

/// Texel beyond a face's edge: it lies in the first or last row or column of the next face.
/// @param texel   (s, t, face), integers: inside a face, or beyond one of its edges
/// @param size    size of a face, in texels, below 2^15
/// @return        (s, t, face) of a texel inside; face -1 beyond a corner, where there is no texel
/// @formula       beyond an edge the point (sc, tc, size), in half texels, moves to (sc, tc, size - 1). There |sc| or
///                |tc| is the largest: it lies along the next face's axis
/// @exactness     A: integers
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_neighbor(glm::vec<3, T> texel, T size) {
    const T u = texel.x * T(2) + T(1) - size, v = texel.y * T(2) + T(1) - size;
    const bool beyond_u = (u > size) || (u < -size);
    const bool beyond_v = (v > size) || (v < -size);
    if (beyond_u && beyond_v) return {T(0), T(0), T(-1)};
    const T m = beyond_u || beyond_v ? size - T(1) : size;
    const glm::vec<3, T> p = cube_plane(cube_point(texel.z, glm::vec<3, T>(u, v, m)));
    return {(p.x + size - T(1)) * T(0.5), (p.y + size - T(1)) * T(0.5), p.z};
}

/// First texel of a face in an atlas of 3 x 2 tiles, with +x, -x, +y in the first row.
/// @param face   0 to 5
/// @param size   size of a tile, in texels
/// @exactness    A
[[nodiscard]] inline glm::ivec2 cube_tile(int face, int size) { return {face % 3 * size, face / 3 * size}; }

namespace glsl {

inline constexpr snippet cube_face{
    .name = "cube_face",
    .summary = "face of a cube that a direction meets",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_view_z{
    .name = "cube_view_z",
    .summary = "distance along the axis of a direction's face",
    .exactness = tier::a,
    .needs = list<&cube_face>,
    .source = R"GLSL(
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
UMBRAGE_HIGHP float umbrage_cube_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
}
)GLSL",
};

inline constexpr snippet cube_plane{
    .name = "cube_plane",
    .summary = "direction in the axes of its face",
    .exactness = tier::a,
    .needs = list<&cube_face>,
    .source = R"GLSL(
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
UMBRAGE_HIGHP vec3 umbrage_cube_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP vec3 x = vec3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    UMBRAGE_HIGHP vec3 y = vec3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    UMBRAGE_HIGHP vec3 z = vec3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_point{
    .name = "cube_point",
    .summary = "point from a face's axes",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
UMBRAGE_HIGHP vec3 umbrage_cube_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(p.z, -p.y, -p.x) : vec3(-p.z, -p.y, p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_face_point{
    .name = "cube_face_point",
    .summary = "point in a face's axes",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
UMBRAGE_HIGHP vec3 umbrage_cube_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(-p.z, -p.y, p.x) : vec3(p.z, -p.y, -p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_coordinate{
    .name = "cube_coordinate",
    .summary = "face of a direction, and the position on it",
    .exactness = tier::c,
    .operations = 5,
    .needs = list<&cube_view_z, &cube_plane>,
    .source = R"GLSL(
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(direction);
    UMBRAGE_HIGHP float m = umbrage_cube_view_z(direction);
    return vec3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
)GLSL",
};

inline constexpr snippet cube_direction{
    .name = "cube_direction",
    .summary = "direction to a point of a cube's face",
    .exactness = tier::b,
    .operations = 2,
    .needs = list<&cube_point>,
    .source = R"GLSL(
// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
UMBRAGE_HIGHP vec3 umbrage_cube_direction(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 st) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 uv = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, vec3(uv, 1.0));
}
)GLSL",
};

inline constexpr snippet cube_neighbor{
    .name = "cube_neighbor",
    .summary = "texel beyond an edge of a cube's face",
    .exactness = tier::a,
    .needs = list<&cube_plane, &cube_point>,
    .source = R"GLSL(
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
UMBRAGE_HIGHP vec3 umbrage_cube_neighbor(UMBRAGE_HIGHP vec3 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 uv = vec2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    UMBRAGE_HIGHP float m = beyond_u || beyond_v ? size - 1.0 : size;
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3(uv, m)));
    UMBRAGE_HIGHP vec2 inside = (vec2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? vec3(0.0, 0.0, -1.0) : vec3(inside, p.z);
}
)GLSL",
};

inline constexpr snippet cube_tile{
    .name = "cube_tile",
    .summary = "first texel of a face in an atlas",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cube_tile(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = face < 2.5 ? 0.0 : 1.0;
    return vec2((face - row * 3.0) * size, row * size);
}
)GLSL",
};

inline constexpr const snippet* cube_map_snippets[]{&cube_face,      &cube_view_z,     &cube_plane,
                                                    &cube_point,     &cube_face_point, &cube_coordinate,
                                                    &cube_direction, &cube_neighbor,   &cube_tile};

}  // namespace glsl
}  // namespace umbrage
