// SPDX-License-Identifier: MIT
//
// Six square maps around a point light: which of them a direction meets and where, as textures of cubes have it, or as
// six tiles of an atlas.
//
//     glm::vec3 at = umbrage::cube_coordinate(world - light);                      // (s, t, face)
//     auto face = atlas.view().region(umbrage::cube_tile(int(at.z), size), {size, size});
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(face), glm::vec2(at) * float(size), depth);
//
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/light/light_space.hpp>
#include <umbrage/scalar.hpp>
#include <umbrage/shader/snippet.hpp>

namespace umbrage {

/// Which way a face's camera looks and what is up for it, NDC y = -1 in its first row.
struct cube_axes {
    glm::ivec3 forward, up;
};

/// Faces in the order of their numbers: +x, -x, +y, -y, +z, -z. A right-handed view along them with 90 degrees each way
/// has its NDC x and y where cube_coordinate has 2 s - 1 and 2 t - 1.
/// @cite   OpenGL 4.6 specification, table 8.19: selection of cube map images
inline const std::array<cube_axes, 6> cube_faces{{{{1, 0, 0}, {0, -1, 0}},
                                                  {{-1, 0, 0}, {0, -1, 0}},
                                                  {{0, 1, 0}, {0, 0, 1}},
                                                  {{0, -1, 0}, {0, 0, -1}},
                                                  {{0, 0, 1}, {0, -1, 0}},
                                                  {{0, 0, -1}, {0, -1, 0}}}};

/// The face that a direction from the cube's middle meets.
/// @param direction   of any length; where two faces meet, x goes before y and y before z
/// @return            0 .. 5; where a NaN leaves no greatest component, 4 or 5
/// @exactness         A: comparisons
template <real T>
[[nodiscard]] constexpr int cube_face(glm::vec<3, T> direction) {
    const auto magnitude = [](T v) { return v < T(0) ? -v : v; };
    const auto at_least = [](T a, T b) { return !is_nan(a) && !is_nan(b) && a >= b; };
    const T x = magnitude(direction.x), y = magnitude(direction.y), z = magnitude(direction.z);
    const int axis = at_least(x, y) ? (at_least(x, z) ? 0 : 2) : (at_least(y, z) ? 1 : 2);
    return 2 * axis + (!is_nan(direction[axis]) && direction[axis] < T(0) ? 1 : 0);
}

/// Where on its face a direction meets the cube.
/// @param direction   of any length; zero and NaN give coordinates that are NaN, which every filter takes as lit
/// @return            (s, t, face): s and t from 0 to 1 over the face, times its size a filter's coordinate
/// @formula           s = (sc + |m|) / 2|m|, t = (tc + |m|) / 2|m|, m the greatest component
/// @exactness         C: divisions, of each of which GLSL allows 2.5 ulp; 0 seen
/// @cite              OpenGL 4.6 specification, table 8.19
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_coordinate(glm::vec<3, T> direction) {
    const int face = cube_face(direction), axis = face / 2;
    const T m = direction[axis] < T(0) ? -direction[axis] : direction[axis];
    const T flip = face % 2 == 0 ? T(1) : T(-1);
    const T sc = axis == 0 ? direction.z * -flip : axis == 1 ? direction.x : direction.x * flip;
    const T tc = axis == 1 ? direction.z * flip : -direction.y;
    return {(sc + m) / (m + m), (tc + m) / (m + m), T(face)};
}

/// The direction to a point of a face: cube_coordinate's inverse.
/// @param face   0 .. 5;   st  from 0 to 1 over the face
/// @return       its greatest component is 1 or -1
/// @exactness    B: 2 s - 1 rounds once
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_direction(T face, glm::vec<2, T> st) {
    const T u = st.x * T(2) - T(1), v = st.y * T(2) - T(1);
    if (face < T(0.5)) return {T(1), -v, -u};
    if (face < T(1.5)) return {T(-1), -v, u};
    if (face < T(2.5)) return {u, T(1), v};
    if (face < T(3.5)) return {u, T(-1), -v};
    if (face < T(4.5)) return {u, -v, T(1)};
    return {-u, -v, T(-1)};
}

/// First texel of a face in an atlas of 3 x 2 tiles: +x, -x, +y in the first row.
/// @param face   0 .. 5;   size  of a tile, in texels
/// @exactness    A
[[nodiscard]] inline glm::ivec2 cube_tile(int face, int size) { return {face % 3 * size, face / 3 * size}; }

namespace glsl {

inline constexpr snippet cube_face{
    .name = "cube_face",
    .summary = "face of a cube that a direction meets",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_coordinate{
    .name = "cube_coordinate",
    .summary = "face, and where on it, that a direction meets",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&cube_face>,
    .source = R"GLSL(
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    bool on_x = face < 1.5;
    bool on_y = face > 1.5 && face < 3.5;
    UMBRAGE_HIGHP float along = on_x ? direction.x : (on_y ? direction.y : direction.z);
    UMBRAGE_HIGHP float m = abs(along);
    UMBRAGE_HIGHP float z = along < 0.0 ? -direction.z : direction.z;
    UMBRAGE_HIGHP float x = along < 0.0 ? -direction.x : direction.x;
    UMBRAGE_HIGHP float sc = on_x ? -z : (on_y ? direction.x : x);
    UMBRAGE_HIGHP float tc = on_y ? z : -direction.y;
    return vec3((sc + m) / (m + m), (tc + m) / (m + m), face);
}
)GLSL",
};

inline constexpr snippet cube_direction{
    .name = "cube_direction",
    .summary = "direction to a point of a cube's face",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_direction(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 st) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float u = st.x * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = st.y * 2.0 - 1.0;
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(1.0, -v, -u) : vec3(-1.0, -v, u);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(u, 1.0, v) : vec3(u, -1.0, -v);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(u, -v, 1.0) : vec3(-u, -v, -1.0);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
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

inline constexpr auto cube_map_snippets = list<&cube_face, &cube_coordinate, &cube_direction, &cube_tile>;

}  // namespace glsl
}  // namespace umbrage
