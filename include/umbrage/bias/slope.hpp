// SPDX-License-Identifier: MIT
//
// How depth changes from texel to texel where a map sees a plane, and the slope-scaled bias that rasterizers have.
//
//     glm::mat4 planes = umbrage::plane_matrix(umbrage::texture_matrix(light, map.size()));  // for planes, not points
//     glm::vec2 slope = umbrage::plane_slope(planes, normal, world);
//     float bias = umbrage::slope_bias(slope, 1.0f, 0.0005f);
//
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

/// What sends planes where a texture matrix sends their points; a map sees a plane as a plane, spot or not.
///
/// @param texture_matrix   world to texels
/// @return                 for plane_slope; the inverse is taken in double
/// @throws std::invalid_argument  a matrix without an inverse, or not finite
/// @formula                transpose(inverse(texture_matrix))
template <real T>
[[nodiscard]] glm::mat<4, 4, T> plane_matrix(const glm::mat<4, 4, T>& texture_matrix) {
    using wide = std::common_type_t<T, double>;  // double, known where this is called: GLM's matrices cost to compile
    const glm::mat<4, 4, T> m(glm::transpose(glm::inverse(glm::mat<4, 4, wide>(texture_matrix))));
    detail::require(detail::all_finite(texture_matrix) && detail::all_finite(m), "plane_matrix", "texture_matrix",
                    "finite, with a finite inverse", texture_matrix);
    return m;
}

/// A slope within what a bias tells apart.
/// @return        -2 .. 2, 2 for NaN: with a reach of half a texel up, acne_free_bias is 1 from 2 on
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_slope(T slope) {
    if (is_nan(slope)) return T(2);
    return slope > T(-2) ? (slope < T(2) ? slope : T(2)) : T(-2);
}

/// Change of depth from one texel to the next, of the plane through a world.
///
/// @param plane_matrix   of the texture matrix
/// @param normal         of the plane, world, of any length
/// @param world          a point on the plane
/// @return               slope in x and y, each -2 .. 2; 2 where the light sees the plane edge-on and for NaN
/// @formula              q = plane_matrix (normal, -normal . world), slope = -(q.x, q.y) / q.z
/// @exactness            C, n = 27: two divisions. S = S(q.xy) S(q.z) / q.z^2, S(q) of the product's magnitudes
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> plane_slope(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                   glm::vec<3, T> world) {
    const T d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    glm::vec<3, T> q(0);
    for (glm::length_t i = 0; i < 3; ++i)
        q[i] = plane_matrix[3][i] * d + plane_matrix[0][i] * normal.x + plane_matrix[1][i] * normal.y +
               plane_matrix[2][i] * normal.z;
    return {clamp_slope(-q.x / q.z), clamp_slope(-q.y / q.z)};
}

/// Change of a receiver's depth from one texel to the next.
/// @param normal   of the surface, any length; zero: a caller who has none, and biases in the depth pass
/// @return         plane_slope; (0, 0) for a normal of zero
/// @exactness      C, n = 27: S as plane_slope
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> receiver_slope(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                      glm::vec<3, T> world) {
    const bool none = normal.x == T(0) && normal.y == T(0) && normal.z == T(0);
    return none ? glm::vec<2, T>(T(0), T(0)) : plane_slope(plane_matrix, normal, world);
}

/// The same in a cascade, where world and texels differ by a rotation, a scale and an offset.
/// @param normal   of the surface, rotated into the light's directions, of any length; zero: a caller who has none
/// @param scale    of the cascade
/// @return         slope in x and y, each -2 .. 2; 2 where the light sees the plane edge-on, and for NaN
/// @formula        -normal.xy scale.z / (normal.z scale.xy)
/// @exactness      C, n = 6: a division; hardware may take products below 2^-126 for 0
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> cascade_slope(glm::vec<3, T> normal, glm::vec<4, T> scale) {
    if (normal.x == T(0) && normal.y == T(0) && normal.z == T(0)) return {T(0), T(0)};
    return {clamp_slope(normal.x * -scale.z / (normal.z * scale.x)),
            clamp_slope(normal.y * -scale.z / (normal.z * scale.y))};
}

/// The bias that rasterizers know, in a shader: so much a slope, on a base.
///
/// @param slope      change of depth from one texel to the next
/// @param factor     texels
/// @param base       depth
/// @return           0 .. 1; 1 for NaN
/// @formula          factor max(|slope.x|, |slope.y|) + base; with a factor of twice a filter's reach it is at
///                   least acne_free_bias, as |slope.x| + |slope.y| <= 2 max(|slope.x|, |slope.y|)
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
    .summary = "clamp of a slope to [-2, 2], NaN to 2",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
)GLSL",
};

inline constexpr snippet plane_slope{
    .name = "plane_slope",
    .summary = "change of a plane's depth from texel to texel",
    .exactness = tier::c,
    .operations = 27,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
UMBRAGE_HIGHP vec2 umbrage_plane_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                       UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x +
                                           plane_matrix[1] * normal.y + plane_matrix[2] * normal.z;
    return vec2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
)GLSL",
};

inline constexpr snippet receiver_slope{
    .name = "receiver_slope",
    .summary = "change of a receiver's depth from texel to texel",
    .exactness = tier::c,
    .operations = 27,
    .needs = list<&plane_slope>,
    .source = R"GLSL(
// umbrage_receiver_slope: umbrage_plane_slope, and (0.0, 0.0) for a normal of zero, of a caller who has none
UMBRAGE_HIGHP vec2 umbrage_receiver_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                          UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec2 slope = umbrage_plane_slope(plane_matrix, normal, world);
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : slope;
}
)GLSL",
};

inline constexpr snippet cascade_slope{
    .name = "cascade_slope",
    .summary = "change of a plane's depth from texel to texel of a cascade",
    .exactness = tier::c,
    .operations = 6,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_cascade_slope: change of depth from one texel to the next; (0.0, 0.0) for a normal of zero
//   normal  of the surface, rotated into the light's directions;   scale  of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * normal.z;
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    UMBRAGE_HIGHP vec2 slope = vec2(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return none ? vec2(0.0, 0.0) : slope;
}
)GLSL",
};

inline constexpr snippet slope_bias{
    .name = "slope_bias",
    .summary = "bias by the greater slope, as rasterizers have it",
    .exactness = tier::b,
    .operations = 2,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
UMBRAGE_HIGHP float umbrage_slope_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float factor,
                                       UMBRAGE_HIGHP float base) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 bias = abs(slope) * factor + base;
    UMBRAGE_HIGHP float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    UMBRAGE_HIGHP float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
)GLSL",
};

inline constexpr const snippet* slope_snippets[]{&clamp_slope, &plane_slope, &receiver_slope, &cascade_slope,
                                                 &slope_bias};

}  // namespace glsl
}  // namespace umbrage
