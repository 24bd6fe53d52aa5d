// SPDX-License-Identifier: MIT
//
// Slope of a plane in the map, its change of depth per texel, and the slope-scaled bias of rasterizers.
//
//     glm::mat4 planes = umbrage::plane_matrix(umbrage::texture_matrix(light, map.size()));  // for planes, not points
//     glm::vec2 slope = umbrage::plane_slope(planes, normal, world);
//     float bias = umbrage::slope_bias(slope, 1.0f, 0.0005f);
//
// See also: acne_free.hpp for a bias without acne; distance_slope.hpp for dual paraboloid maps.
#pragma once

#include <cmath>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

namespace detail {

/// Body of plane_matrix. Errors name `function` and `argument`.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> plane_matrix(const glm::mat<4, 4, T>& texture_matrix, const char* function,
                                             const char* argument, const char* condition) {
    using wide = std::common_type_t<T, double>;  // double, but dependent: GLM's matrices cost compile time
    const glm::mat<4, 4, T> m(glm::transpose(glm::inverse(glm::mat<4, 4, wide>(texture_matrix))));
    require(all_finite(texture_matrix) && all_finite(m), function, argument, condition, texture_matrix);
    return m;
}

/// plane_matrix of a light's map, for a shadow.
[[nodiscard]] inline glm::dmat4 plane_matrix_of_shadow(const glm::dmat4& texture_matrix) {
    return plane_matrix(texture_matrix, "shadow", "light and origin",
                        "such that the map's matrix has a finite inverse");
}

}  // namespace detail

/// Matrix that transforms planes as a texture matrix transforms points. A plane stays a plane, under a spot light too.
///
/// @param texture_matrix   matrix from the world to texels
/// @return                 matrix for plane_slope; the inverse is computed in double
/// @throws std::invalid_argument  a matrix without an inverse, or not finite
/// @formula                transpose(inverse(texture_matrix))
template <real T>
[[nodiscard]] glm::mat<4, 4, T> plane_matrix(const glm::mat<4, 4, T>& texture_matrix) {
    return detail::plane_matrix(texture_matrix, "plane_matrix", "texture_matrix", "finite, with a finite inverse");
}

/// Slope clamped to the range that matters to a bias.
/// @return        slope from -2 to 2. With a reach of half a texel or more, acne_free_bias is 1 from 2 on
/// @edge          NaN: 2
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_slope(T slope) {
    if (is_nan(slope)) return T(2);
    return slope > T(-2) ? (slope < T(2) ? slope : T(2)) : T(-2);
}

/// Normal, in a map, of the plane through a world position.
/// @param plane_matrix   plane_matrix of the texture matrix
/// @param normal         normal of the plane, world, any length
/// @param world          world position of a point on the plane
/// @return               normal in texels, texels and depth, of any length; its z is 0 for a plane seen edge-on
/// @formula              xyz of plane_matrix (normal, -normal . world)
/// @exactness            B, n = 12
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> plane_in_map(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                    glm::vec<3, T> world) {
    const T d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    glm::vec<3, T> q(0);
    for (glm::length_t i = 0; i < 3; ++i)
        q[i] = plane_matrix[3][i] * d + plane_matrix[0][i] * normal.x + plane_matrix[1][i] * normal.y +
               plane_matrix[2][i] * normal.z;
    return q;
}

/// Change of depth per texel of the plane through a world position.
///
/// @param plane_matrix   plane_matrix of the texture matrix
/// @param normal         normal of the plane, world, any length
/// @param world          world position of a point on the plane
/// @return               slope in x and y, each -2 to 2
/// @edge                 plane seen edge-on by the light, or NaN: 2
/// @formula              -(q.x, q.y) / q.z, where q = plane_in_map
/// @exactness            C, n = 27: two divisions. S = S(q.xy) S(q.z) / q.z^2, S(q) of the product's magnitudes
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> plane_slope(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                   glm::vec<3, T> world) {
    const glm::vec<3, T> q = plane_in_map(plane_matrix, normal, world);
    return {clamp_slope(-q.x / q.z), clamp_slope(-q.y / q.z)};
}

/// Change of a receiver's depth per texel, in a place of a shadow: plane_slope without its clamps.
/// @param plane_matrix   from plane_matrix
/// @param normal         surface normal, any length. Pass zero if there is none and the depth pass has the bias
/// @param world          point on the surface, world units
/// @return               slope of any size
/// @edge                 zero normal: (0, 0). Plane seen edge-on by the light: far above 2, infinite or NaN,
///                       but for q.xy near 1e-30, which counts as no normal
/// @formula              as plane_slope, but over 1e-30 where q.z is 0: q.xy are 0 without a normal, and not with one
/// @exactness            C, n = 27: S as plane_slope
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> receiver_slope(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                      glm::vec<3, T> world) {
    const glm::vec<3, T> q = plane_in_map(plane_matrix, normal, world);
    const T depth = q.z == T(0) ? T(1e-30) : q.z;
    return {-q.x / depth, -q.y / depth};
}

/// Change of a receiver's depth per texel in a cascade, where texels are world positions rotated, scaled and offset.
/// @param normal   surface normal, rotated into the light's axes, any length. Pass zero if there is none
/// @param scale    scale of the cascade
/// @return         slope of any size
/// @edge           zero normal: (0, 0). Plane seen edge-on by the light: far above 2, infinite or NaN,
///                 but for a normal of length near 1e-18, which counts as none
/// @formula        -normal.xy scale.z / (normal.z scale.xy), with 1e-18 for a normal.z of 0
/// @exactness      C, n = 6: a division; hardware may take products below 2^-126 for 0
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> cascade_slope(glm::vec<3, T> normal, glm::vec<4, T> scale) {
    const T z = normal.z == T(0) ? T(1e-18) : normal.z;
    return {normal.x * -scale.z / (z * scale.x), normal.y * -scale.z / (z * scale.y)};
}

/// Slope-scaled bias of rasterizers, computed in a shader.
///
/// @param slope      change of depth per texel
/// @param factor     factor of the slope, in texels
/// @param base       constant bias, in depth
/// @return           bias in depth, 0 to 1
/// @edge             NaN: 1
/// @formula          factor max(|slope.x|, |slope.y|) + base. With a factor of 2 reach it is at least acne_free_bias,
///                   since |slope.x| + |slope.y| <= 2 max(|slope.x|, |slope.y|)
/// @exactness        B, n = 2
template <real T>
[[nodiscard]] constexpr T slope_bias(glm::vec<2, T> slope, T factor, T base) {
    const T x = clamp_bias(factor * (slope.x < T(0) ? -slope.x : slope.x) + base);
    const T y = clamp_bias(factor * (slope.y < T(0) ? -slope.y : slope.y) + base);
    return x > y ? x : y;
}

namespace glsl {

inline constexpr snippet clamp_slope{
    .name = "clamp_slope",
    .summary = "clamp of a slope to [-2, 2]; NaN becomes 2",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return abs(slope) < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
)GLSL",
};

inline constexpr snippet plane_in_map{
    .name = "plane_in_map",
    .summary = "normal of a plane in a map",
    .exactness = tier::b,
    .operations = 12,
    .source = R"GLSL(
// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
UMBRAGE_HIGHP vec3 umbrage_plane_in_map(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                        UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y +
                           plane_matrix[2] * normal.z;
    return vec3(q.x, q.y, q.z);
}
)GLSL",
};

inline constexpr snippet plane_slope{
    .name = "plane_slope",
    .summary = "change of a plane's depth per texel",
    .exactness = tier::c,
    .operations = 27,
    .needs = list<&clamp_slope, &plane_in_map>,
    .source = R"GLSL(
// umbrage_plane_slope: change of depth per texel, in x and y, of the plane through a point
//   plane_matrix, normal, world   as for umbrage_plane_in_map
UMBRAGE_HIGHP vec2 umbrage_plane_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                       UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    return vec2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
)GLSL",
};

inline constexpr snippet receiver_slope{
    .name = "receiver_slope",
    .summary = "change of a receiver's depth per texel",
    .exactness = tier::c,
    .operations = 27,
    .needs = list<&plane_in_map>,
    .source = R"GLSL(
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
UMBRAGE_HIGHP vec2 umbrage_receiver_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                          UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    UMBRAGE_HIGHP float depth = q.z == 0.0 ? 1.0e-30 : q.z;  // q is zero without a normal, and not where edge-on
    return vec2(-q.x / depth, -q.y / depth);
}
)GLSL",
};

inline constexpr snippet cascade_slope{
    .name = "cascade_slope",
    .summary = "change of a plane's depth per texel in a cascade",
    .exactness = tier::c,
    .operations = 6,
    .source = R"GLSL(
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_HIGHP float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * z;
    return vec2(up.x / across.x, up.y / across.y);
}
)GLSL",
};

inline constexpr snippet slope_bias{
    .name = "slope_bias",
    .summary = "slope-scaled bias, as rasterizers compute it",
    .exactness = tier::b,
    .operations = 2,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
UMBRAGE_HIGHP float umbrage_slope_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float factor,
                                       UMBRAGE_HIGHP float base) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 bias = abs(slope) * factor + base;
    UMBRAGE_HIGHP float x = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    UMBRAGE_HIGHP float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
)GLSL",
};

inline constexpr const snippet* slope_snippets[]{&clamp_slope,    &plane_in_map,  &plane_slope,
                                                 &receiver_slope, &cascade_slope, &slope_bias};

}  // namespace glsl
}  // namespace umbrage
