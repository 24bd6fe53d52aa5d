// SPDX-License-Identifier: MIT
//
// Texture matrix from the world to the shadow map, matrices for four taps, and the vertex shader's use of them.
//
//     glm::mat4 m = umbrage::texture_matrix(light, {1024, 1024});
//     glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(m, world));  // x and y in texels, depth
//
// Far from the world's origin, use a light in double, and points relative to an origin near the camera:
//
//     glm::mat4 m = umbrage::texture_matrix(light, {1024, 1024}, origin);
//     draw_depths(umbrage::relative_to(light, origin));
//     glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(m, glm::vec3(world - origin)));
//
// Also called: shadow matrix, bias matrix, depthBiasMVP, unity_WorldToShadow, world-to-shadow matrix (texture_matrix);
// shadowCoord, FragPosLightSpace, vShadowCoord (shadow_coordinate); perspective divide, projCoords
// (project_coordinate); floating origin, camera-relative rendering, large worlds (relative_to); tap matrices, a texture
// matrix per tap (tap_matrices).
#pragma once

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Matrix from the world to texels and depth, before the division by w.
///
/// @param light      light of the map
/// @param map_size   map size in texels, each >= 1; the first texel's center is (0.5, 0.5). (1, 1) gives UV coordinates
/// @return           matrix to (x w, y w, depth w, w). Depth is in [0, 1] in every clip space. Reversed depth stays
///                   reversed
/// @formula          scale and bias * projection * view; y is flipped for texture_origin::top, and z of
///                   [-1, 1] clip space becomes z / 2 + 1 / 2
/// @throws std::invalid_argument  map_size below 1; clip unset; a matrix that would not be finite
template <real T>
[[nodiscard]] glm::mat<4, 4, T> texture_matrix(const light_space<T>& light, glm::ivec2 map_size) {
    detail::require_given(light.clip, "texture_matrix", "light.clip");
    detail::require(map_size.x >= 1 && map_size.y >= 1, "texture_matrix", "map_size", "above 0", map_size);
    const glm::vec<2, T> half = glm::vec<2, T>(map_size) * T(0.5);
    glm::mat<4, 4, T> scale_bias(T(1));
    scale_bias[0][0] = half.x;
    scale_bias[1][1] = light.clip.origin == texture_origin::bottom ? half.y : -half.y;
    scale_bias[3][0] = half.x;
    scale_bias[3][1] = half.y;
    if (light.clip.range == depth_range::minus_one_to_one) {
        scale_bias[2][2] = T(0.5);
        scale_bias[3][2] = T(0.5);
    }
    const glm::mat<4, 4, T> m = scale_bias * light.projection * light.view;
    detail::require(detail::all_finite(m), "texture_matrix", "light and map_size", "such that their matrix is finite",
                    m);
    return m;
}

/// Matrix from points relative to an origin to texels and depth: the product in double, rounded once.
///
/// The origin may change from frame to frame. A world point keeps its place in a stable map to 1/100 texel while it and
/// the map are within 10,000 texels of each origin.
/// @param light    light of the map
/// @param map_size map size in texels, each >= 1
/// @param origin   world position near the camera, such as an engine's floating origin
/// @throws std::invalid_argument  map_size below 1; clip unset; a matrix that would not be finite in float
[[nodiscard]] inline glm::mat4 texture_matrix(const light_space<double>& light, glm::ivec2 map_size,
                                              glm::dvec3 origin) {
    glm::dmat4 m = texture_matrix(light, map_size);
    m[3] = m * glm::dvec4(origin, 1.0);
    const glm::mat4 rounded(m);
    detail::require(detail::all_finite(rounded), "texture_matrix", "light, map_size and origin",
                    "such that their matrix is finite", rounded);
    return rounded;
}

/// Light in float for points relative to an origin, from a light in double. Use it in the depth pass.
/// @param light    light in world units
/// @param origin   world position near the camera, such as an engine's floating origin
/// @return         light space. A view that is a rotation stays one: large terms cancel in the projection
/// @throws std::invalid_argument  matrices that would not be finite in float
[[nodiscard]] inline light_space<float> relative_to(const light_space<double>& light, glm::dvec3 origin) {
    const glm::dvec4 at = light.view * glm::dvec4(origin, 1.0);
    glm::dmat4 view = light.view, projection = light.projection;
    const bool rotates = glm::dvec3(view[3]) == glm::dvec3(0);
    (rotates ? projection : view)[3] = rotates ? projection * at : at;
    return detail::checked<float>({glm::mat4(view), glm::mat4(projection), light.clip, light.parallel}, "relative_to",
                                  "light and origin");
}

namespace detail {

/// Change of a point's texel coordinates and depth per step along a vector.
template <real T>
[[nodiscard]] glm::vec<3, T> step(const glm::mat<4, 4, T>& texture_matrix, glm::vec<3, T> world, glm::vec<3, T> along) {
    const glm::vec<4, T> h = texture_matrix * glm::vec<4, T>(world, T(1));
    const glm::vec<4, T> d = texture_matrix * glm::vec<4, T>(along, T(0));
    return (glm::vec<3, T>(d) - glm::vec<3, T>(h) * (d.w / h.w)) / h.w;
}

}  // namespace detail

/// Taps of the 2002 sample: half a texel from the center in x and y.
template <real T>
inline const std::array<glm::vec<2, T>, 4> default_taps{
    {{T(-0.5), T(-0.5)}, {T(0.5), T(-0.5)}, {T(-0.5), T(0.5)}, {T(0.5), T(0.5)}}};

/// One texture matrix per tap, for hardware and shaders that cannot offset a projective coordinate later.
///
/// @param texture_matrix   matrix from the world to texels
/// @param offsets          offsets of the taps, in texels
/// @return                 matrices that apply the offset before the division by w. In exact arithmetic that equals
///                         adding it afterwards
/// @throws std::invalid_argument  a matrix that would not be finite
/// @formula                translate(offset) * texture_matrix
/// @accuracy               in binary32 within 6 ulp of (|m0 x| + |m1 y| + |m2 z| + |m3|) / w, the sum of the magnitudes
///                         behind a coordinate. The worst error seen is 4.5 ulp; tap_coordinate stays closer
/// @cite                   ATI Radeon SDK, ShadowMap sample, 2002
template <real T>
[[nodiscard]] std::array<glm::mat<4, 4, T>, 4> tap_matrices(
    const glm::mat<4, 4, T>& texture_matrix, const std::array<glm::vec<2, T>, 4>& offsets = default_taps<T>) {
    std::array<glm::mat<4, 4, T>, 4> taps;
    for (std::size_t tap = 0; tap < 4; ++tap) {
        taps[tap] = texture_matrix;
        for (int column = 0; column < 4; ++column) {
            taps[tap][column][0] += offsets[tap].x * texture_matrix[column][3];
            taps[tap][column][1] += offsets[tap].y * texture_matrix[column][3];
        }
        detail::require(detail::all_finite(taps[tap]), "tap_matrices", "texture_matrix and offsets",
                        "such that their matrix is finite", taps[tap]);
    }
    return taps;
}

/// World position times a texture matrix: the vertex shader's part.
/// @formula       m[3] + m[0] x + m[1] y + m[2] z, summed from left to right. GLSL compilers were seen to keep this
///                order without `precise`. They move an m[3] at the end to the front
/// @exactness     B, n = 6
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> shadow_coordinate(const glm::mat<4, 4, T>& m, glm::vec<3, T> world) {
    glm::vec<4, T> c(0);
    for (glm::length_t row = 0; row < 4; ++row)
        c[row] = m[3][row] + m[0][row] * world.x + m[1][row] * world.y + m[2][row] * world.z;
    return c;
}

/// Coordinate of a tap from that of the center: the result of the tap's own matrix, without the matrix.
/// @param coordinate   result of shadow_coordinate, before the division by w
/// @param offset       offset of the tap, in texels
/// @return             coordinate before the division by w
/// @accuracy           after the division, within 3 ulp of adding the offset later (worst seen 1.9)
/// @formula            (x + offset.x w, y + offset.y w, z, w)
/// @exactness          B, n = 2
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> tap_coordinate(glm::vec<4, T> coordinate, glm::vec<2, T> offset) {
    return {coordinate.x + offset.x * coordinate.w, coordinate.y + offset.y * coordinate.w, coordinate.z, coordinate.w};
}

/// Coordinate after the division by w, as filters take it.
/// @return        x and y in texels, z depth
/// @edge          w <= 0 (not in front of the light) or NaN in w: (65536, 65536, 0), which every filter takes as lit
/// @exactness     C, n = 3: divisions. S = the result's magnitude
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> project_coordinate(glm::vec<4, T> coordinate) {
    if (is_nan(coordinate.w) || !(coordinate.w > T(0))) return {T(65536), T(65536), T(0)};
    return {coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w};
}

namespace glsl {

inline constexpr snippet shadow_coordinate{
    .name = "shadow_coordinate",
    .summary = "world to texels and depth, before the division by w",
    .exactness = tier::b,
    .operations = 6,
    .source = R"GLSL(
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
)GLSL",
};

inline constexpr snippet tap_coordinate{
    .name = "tap_coordinate",
    .summary = "coordinate of a tap from the center's, before division by w",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
UMBRAGE_HIGHP vec4 umbrage_tap_coordinate(UMBRAGE_HIGHP vec4 coordinate, UMBRAGE_HIGHP vec2 offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moved = vec2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4(moved.x, moved.y, coordinate.z, coordinate.w);
}
)GLSL",
};

inline constexpr snippet project_coordinate{
    .name = "project_coordinate",
    .summary = "division by w; lit behind the light",
    .exactness = tier::c,
    .operations = 3,
    .source = R"GLSL(
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
UMBRAGE_HIGHP vec3 umbrage_project_coordinate(UMBRAGE_HIGHP vec4 coordinate) {
    UMBRAGE_HIGHP vec3 p = vec3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : vec3(65536.0, 65536.0, 0.0);
}
)GLSL",
};

inline constexpr const snippet* texture_matrix_snippets[]{&shadow_coordinate, &tap_coordinate, &project_coordinate};

}  // namespace glsl
}  // namespace umbrage
