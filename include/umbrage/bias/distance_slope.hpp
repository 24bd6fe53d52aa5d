// SPDX-License-Identifier: MIT
//
// Slope of a plane in a dual paraboloid map, where depth is the distance from the light: its change per texel.
// Use it there in place of `plane_slope`.
//
//     glm::vec2 slope = umbrage::dual_paraboloid_slope(world - light.position, normal, 2.0f / (light.range * inner));
//     float bias = umbrage::acne_free_bias(slope, filter.reach() + umbrage::tessellation_reach<float>, error);
//
#pragma once

#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Position error in texels of a tessellated mesh in a dual paraboloid map. Add it to a filter's reach.
template <real T>
inline constexpr T tessellation_reach = T(0.825);

/// Largest change of distance per texel, shared equally by both axes: |x| + |y| is the change along the diagonal.
///
/// @param way         vector from the light to the receiver, of length 1e-18 to 1e18
/// @param normal      surface normal, any length. Pass zero if there is none
/// @param per_texel   2 / (range (map_size - 2 border)) of the light
/// @return            slope (s, s), s from 0 to 2
/// @edge              plane seen edge-on by the light, or NaN: s = 2. Zero normal: s = 0
/// @formula           s = sqrt(1/2) per_texel (|p| + |p.z|) |n x p| / |n . p|. A texel is 2 (1 + |p.z| / |p|) /
///                    (map_size - 2 border) radians wide. Distance grows by |p| tan(angle of n and p) per radian
/// @exactness         C, n = 41: square roots and a division. S(n . p) / |n . p| counts as one value more
template <real T>
[[nodiscard]] glm::vec<2, T> dual_paraboloid_slope(glm::vec<3, T> way, glm::vec<3, T> normal, T per_texel) {
    if (normal.x == T(0) && normal.y == T(0) && normal.z == T(0)) return {T(0), T(0)};
    const T square = way.x * way.x + way.y * way.y + way.z * way.z;
    const T x = normal.y * way.z - normal.z * way.y;
    const T y = normal.z * way.x - normal.x * way.z;
    const T z = normal.x * way.y - normal.y * way.x;
    const T across = x * x + y * y + z * z;
    const T along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    const T wide = (std::sqrt(square) + (way.z < T(0) ? -way.z : way.z)) * (per_texel * T(0.70710678118654752440));
    const T slope = clamp_slope(wide * std::sqrt(across) / (along < T(0) ? -along : along));
    return {slope, slope};
}

namespace glsl {

inline constexpr snippet dual_paraboloid_slope{
    .name = "dual_paraboloid_slope",
    .summary = "change of distance per texel in a dual paraboloid map",
    .exactness = tier::c,
    .operations = 41,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
UMBRAGE_HIGHP vec2 umbrage_dual_paraboloid_slope(UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = way.x * way.x + way.y * way.y + way.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * way.z - normal.z * way.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * way.x - normal.x * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * way.y - normal.y * way.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float across = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    UMBRAGE_HIGHP float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : vec2(slope, slope);
}
)GLSL",
};

inline constexpr const snippet* distance_slope_snippets[]{&dual_paraboloid_slope};

}  // namespace glsl
}  // namespace umbrage
