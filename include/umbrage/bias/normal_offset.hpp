// SPDX-License-Identifier: MIT
//
// Normal offset bias: moves the receiver off its surface along the normal before the lookup, by the surface's tilt.
//
//     float width = umbrage::offset_width(filter.reach(), umbrage::texels_to_world(1.0f, units, w));
//     glm::vec3 way = spot ? (world - light_position) / w : light_direction;
//     glm::vec3 point = world + umbrage::normal_offset(normal, light_direction, way, width, 0.0f);
//
// The offset is in world space, so the direction of depth does not matter. It is 0 where the light hits head-on.
// Also called: normal bias (three.js normalBias, Unity Normal Bias), normal offset shadows (normal_offset).
// See also: acne_free.hpp, a bias in depth.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Length of the normal offset that avoids acne on a plane lit at a grazing angle.
/// @param reach         filter radius in texels, as for acne_free_bias
/// @param texel_world   edge of a texel's footprint, world units
/// @return        world units
/// @formula       sqrt(2) reach texel_world with the root rounded up: the distance to the corner of the filter's kernel
template <real T>
[[nodiscard]] constexpr T offset_width(T reach, T texel_world) {
    return T(1.4142137) * reach * texel_world;
}

/// Offset from a surface point to the point to look up.
///
/// @param normal        surface normal of length one, on the visible side. Zero: no offset
/// @param direction     direction of the light, or of a spot's axis, of length one. The texels lie across it
/// @param way           vector from the light to the point over w, the distance along the axis; for a directional light
///                      its direction again
/// @param width         result of offset_width, world units
/// @param error_world   error of the map's depths along the light, world units; see error of acne_free_bias
/// @return              world units
/// @edge                result not finite, or 2^64 or more: 0
/// @formula             normal (width |normal x direction| + error_world |normal . way|)
/// @accuracy            let t be the angle between normal and light. An offset d gains d / cos t along the light, and a
///                      texel's step loses texel tan t. The offset suffices for a directional light. For a spot light
///                      it suffices where the normal points against the axis
/// @detaches            as a bias of width tan t + error_world along the light. On a floor at the foot of an upright
///                      wall, light leaks into a strip of up to width tan t sin t
/// @exactness           C, n = 91: a square root. S = |normal| (width s^2 / |normal x direction| + error_world c), with
///                      s, c for |normal x direction|, |normal . way| of magnitudes and pluses
template <real T>
[[nodiscard]] glm::vec<3, T> normal_offset(glm::vec<3, T> normal, glm::vec<3, T> direction, glm::vec<3, T> way, T width,
                                           T error_world) {
    const T x = normal.y * direction.z + normal.z * -direction.y;
    const T y = normal.z * direction.x + normal.x * -direction.z;
    const T z = normal.x * direction.y + normal.y * -direction.x;
    const T straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    const T along = width * std::sqrt(x * x + y * y + z * z) + error_world * std::abs(straight);
    const glm::vec<3, T> offset = normal * along;
    const T extent = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z);
    const bool finite = !is_nan(extent) & (extent < T(0x1p64));  // no branch, so that loops vectorize
    return {finite ? offset.x : T(0), finite ? offset.y : T(0), finite ? offset.z : T(0)};
}

namespace glsl {

inline constexpr snippet normal_offset{
    .name = "normal_offset",
    .summary = "offset along the normal to the point to look up",
    .exactness = tier::c,
    .operations = 91,
    .source = R"GLSL(
// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
UMBRAGE_HIGHP vec3 umbrage_normal_offset(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction,
                                         UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP float width,
                                         UMBRAGE_HIGHP float error_world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = width * sqrt(square) + error_world * abs(straight);
    UMBRAGE_HIGHP vec3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : vec3(0.0, 0.0, 0.0);
}
)GLSL",
};

inline constexpr const snippet* normal_offset_snippets[]{&normal_offset};

}  // namespace glsl
}  // namespace umbrage
