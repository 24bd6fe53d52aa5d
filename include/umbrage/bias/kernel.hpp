// SPDX-License-Identifier: MIT
//
// Bias from a surface's normal that grows with the filter kernel and the light's angle of incidence.
//
//     float width = umbrage::offset_width(filter.reach(), umbrage::texels_to_world(1.0f, units, w));
//     float world = umbrage::kernel_bias(normal, light_direction, way, width, 20.0f);  // way as for normal_offset
//     float bias = umbrage::world_to_depth(world, units, w);
//
// Also called: cone bias, tan(acos(N.L)) (kernel_bias).
// See also: acne_free.hpp, from a plane's slope; normal_offset.hpp, which moves the receiver along its normal.
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Distance along the light that a filter's kernel extends beyond a surface's plane, towards the light.
///
/// @param normal      surface normal, any length, on the visible side
/// @param direction   direction of the light, or of a spot's axis, of length one
/// @param way         vector from the light to the point over w; for a directional light its direction again
/// @param width       half diagonal of the kernel, from offset_width, in world units or in depth
/// @param greatest    limit of the tangent, above which the bias does not grow, >= 0
/// @return            bias in the unit of width, 2^-64 to 2^64
/// @edge              grazing light, light from behind, zero normal, or NaN: width greatest. Result out of range: 0
/// @formula           width min(|normal x direction| / -(normal . way), greatest)
/// @accuracy          up to the limit, 1 to sqrt(2) times acne_free_bias without its constant part. The factor depends
///                    on the rotation of the plane
/// @detaches          casters nearer than the bias along the light lose their shadow: at most width greatest
/// @exactness         C, n = 30: a square root and a division. S = width s^2 c / (|normal x direction| (normal .
///                    way)^2) with s, c for |normal x direction|, |normal . way| of magnitudes and pluses
template <real T>
[[nodiscard]] T kernel_bias(glm::vec<3, T> normal, glm::vec<3, T> direction, glm::vec<3, T> way, T width, T greatest) {
    const T x = normal.y * direction.z + normal.z * -direction.y;
    const T y = normal.z * direction.x + normal.x * -direction.z;
    const T z = normal.x * direction.y + normal.y * -direction.x;
    const T sine = std::sqrt(x * x + y * y + z * z);
    const T cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    const bool grazing = is_nan(cosine) || is_nan(sine) || !(cosine * greatest > sine);
    const T bias = width * (grazing ? greatest : sine / cosine);
    return !is_nan(bias) && bias >= T(0x1p-64) && bias < T(0x1p64) ? bias : T(0);
}

namespace glsl {

inline constexpr snippet kernel_bias{
    .name = "kernel_bias",
    .summary = "bias from kernel width and angle of the light",
    .exactness = tier::c,
    .operations = 30,
    .source = R"GLSL(
// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
UMBRAGE_HIGHP float umbrage_kernel_bias(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 way,
                                        UMBRAGE_HIGHP float width, UMBRAGE_HIGHP float greatest) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_HIGHP float sine = sqrt(square);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge = cosine * greatest;
    UMBRAGE_HIGHP float tangent = edge > sine ? sine / cosine : greatest;
    UMBRAGE_HIGHP float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
)GLSL",
};

inline constexpr const snippet* kernel_snippets[]{&kernel_bias};

}  // namespace glsl
}  // namespace umbrage
