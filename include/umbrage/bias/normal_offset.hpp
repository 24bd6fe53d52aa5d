// SPDX-License-Identifier: MIT
//
// The point to look up instead of a surface's own: off it along the normal, by what the surface's tilt asks for.
//
//     float width = umbrage::offset_width(filter.reach(), umbrage::texels_to_world(1.0f, units, w));
//     glm::vec3 way = spot ? (world - light_position) / w : light_direction;
//     glm::vec3 point = world + umbrage::normal_offset(normal, light_direction, way, width, 0.0f);
//
// In world space, so that the direction of depth does not matter; nothing where the light falls straight on a surface.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// How far along its normal a surface is looked up where light grazes it, so that no plane shadows itself.
/// @param reach   of the filter, texels, as for acne_free_bias;   texel_world  edge of a texel's footprint
/// @return        world units
/// @formula       sqrt(2) reach texel_world, the root rounded up: to the corner of what the filter reads
template <real T>
[[nodiscard]] constexpr T offset_width(T reach, T texel_world) {
    return T(1.4142137) * reach * texel_world;
}

/// The way from a surface to the point that is looked up in its place.
///
/// @param normal        of the surface, of length one, on the side that is seen; zero: no offset
/// @param direction     of the light, a spot's axis, of length one: what a map's texels lie across
/// @param way           from the light to the point over w, the distance along the axis; for a directional light its
///                      direction once more
/// @param width         world units, offset_width
/// @param error_world   world units along the light that the map's depths are off by, e of acne_free_bias
/// @return              world units; 0 where it is not finite, or 2^64 and more
/// @formula             normal (width |normal x direction| + error_world |normal . way|): with t the angle between
///                      normal and light, d along the normal wins d / cos t along the light, where a texel's step loses
///                      texel tan t. Enough for a directional light; for a spot where the normal looks against its axis
/// @detaches            as width tan t + error_world along the light: on a floor beside a wall that stands square to it
///                      light leaks in for up to width tan t sin t
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
    const bool finite = !is_nan(extent) & (extent < T(0x1p64));  // no branch: loops become vectors
    return {finite ? offset.x : T(0), finite ? offset.y : T(0), finite ? offset.z : T(0)};
}

namespace glsl {

inline constexpr snippet normal_offset{
    .name = "normal_offset",
    .summary = "way off a surface to the point that is looked up in its place",
    .exactness = tier::c,
    .operations = 91,
    .source = R"GLSL(
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
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
