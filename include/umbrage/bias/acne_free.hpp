// SPDX-License-Identifier: MIT
//
// Depth bias without shadow acne for a filter's whole kernel, from the receiver's slope, the filter's reach and the
// map's encoding. It is at most 10 % above the smallest.
//
//     umbrage::filters::box filter{.radius = 2};
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);  // depth per texel
//     float bias = umbrage::acne_free_bias(slope, filter, umbrage::rg<11>{});
//     float visibility = filter(fetch, glm::vec2(p), umbrage::biased(p.z, bias, filter.direction));
//
// The reach is the filter radius in texels. A filter compares a receiver with texel centers up to its reach away in x
// and y. There a plane of slope (a, b) may be nearer to the light by reach (|a| + |b|). The stored depth may be nearer
// still by the encoding's error. The bias covers both. With 9/10 of it some receivers are dark.
// Also called: the Bias sliders of Unity, Unreal and Godot, adaptive depth bias, optimal bias (acne_free_bias);
// peter-panning, light gap (peter_panning_distance).
// See also: slope.hpp for the slope, receiver_plane.hpp.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// Reach in texels to add if the depth pass moves vertices to a subpixel grid, as rasterizers do.
/// @tparam SubTexelBits   bits of the grid: 8 in Direct3D, at least 4 in Vulkan (subPixelPrecisionBits) and OpenGL
///                        (SUBPIXEL_BITS). WebGL, WebGPU and Metal state none
/// @formula               4 times the largest move, which is half a step of 2^-SubTexelBits texel
template <real T, int SubTexelBits = 8>
inline constexpr T rasterizer_snap = T(2) / T(1 << SubTexelBits);

/// Depth bias without shadow acne, for filters that read whole rows and columns: at most 10 % above the smallest.
///
/// @param slope   change of the receiver's depth per texel, in x and y, from plane_slope or receiver_plane_slope
/// @param reach   filter radius, in texels. Add 2^-12 texel per 4096 texels of map size for coordinates that round. Add
///                rasterizer_snap if a rasterizer has moved the vertices
/// @param error   largest error of a decoded depth towards the light: decoding_error::below, or above for reversed
///                depth. For a UNORM depth texture 1/2 / (2^bits - 1)
/// @return        bias in depth, 0 to 1. With a bias of 1 nothing is in shadow
/// @edge          infinite slope or reach, or NaN: 1
/// @formula       reach (|slope.x| + |slope.y|) + error + 2^-23
/// @accuracy      2^-23 covers the rounding of a depth in binary32. Add to error what a float matrix lost before: about
///                2^-22 of a z/w near 1
/// @detaches      casters nearer to the receiver than peter_panning_distance() lose their shadow (peter-panning)
/// @exactness     B, n = 4
template <real T>
[[nodiscard]] constexpr T acne_free_bias(glm::vec<2, T> slope, T reach, T error) {
    const T sum = (slope.x < T(0) ? -slope.x : slope.x) + (slope.y < T(0) ? -slope.y : slope.y);
    return clamp_bias(reach * sum + (error + T(0x1p-23)));
}

/// Depth bias without shadow acne, for filters that read a disc: at most 10 % above the smallest.
///
/// @param slope          as for acne_free_bias
/// @param error          as for acne_free_bias
/// @param radius         distance from the receiver to the farthest sample point, in texels. The center of the point's
///                       texel lies up to half a texel farther, and 1/128 texel more for the rounding of points
/// @return               bias in depth, 0 to 1
/// @edge                 infinite values or NaN: 1
/// @formula              radius |slope| + (1/2 + 1/128) (|slope.x| + |slope.y|) + error + 2^-23
/// @exactness            C, n = 13: a square root
template <real T>
[[nodiscard]] T acne_free_disc_bias(glm::vec<2, T> slope, T radius, T error) {
    const T sum = std::abs(slope.x) + std::abs(slope.y);
    const T length = std::sqrt(slope.x * slope.x + slope.y * slope.y);
    return clamp_bias(radius * length + (sum * T(0.5078125) + (error + T(0x1p-23))));
}

/// Depth bias for a filter over a map with an encoding. The encoding's depth direction selects its error.
/// @param slope      change of depth per texel in x and y
/// @param filter     a filter of filters.hpp, for its reach
/// @param encoding   an encoding of encodings.hpp, for its error
/// @param more       texels to add to the reach, for rasterizer_snap and for coordinates that round
[[nodiscard]] constexpr float acne_free_bias(glm::vec2 slope, const known_filter auto& filter,
                                             const known_encoding auto& encoding, float more = 0.0f) {
    const decoding_error both = encoding.error();
    const auto error = float(encoding.direction == depth_direction::forward ? both.below : both.above);
    if constexpr (requires { filter.farthest_point(); })
        return acne_free_disc_bias(slope, filter.farthest_point() + more, error);
    else return acne_free_bias(slope, filter.reach() + more, error);
}

/// Distance in depth from the receiver within which casters lose their shadow, wholly or in part (peter-panning).
///
/// @param bias           bias of the receiver, in depth
/// @param caster_slope   change of the caster's depth per texel. It is 0 for a caster that faces the light
/// @param reach          filter radius, in texels
/// @return               depth, 0 to 1. A caster at least this far from the receiver casts its full shadow
/// @edge                 infinite values or NaN: 1
/// @formula              bias + reach (|caster_slope.x| + |caster_slope.y|) + 2^-23
/// @detaches             light leaks in on a floor at the foot of an upright wall, over a width of bias sin(t).
///                       With t the angle between the floor's normal and the light, the width is at most sqrt(2) reach
///                       texel tan(t) sin(t) world units
/// @exactness            B, n = 4
template <real T>
[[nodiscard]] constexpr T peter_panning_distance(T bias, glm::vec<2, T> caster_slope, T reach) {
    return acne_free_bias(caster_slope, reach, bias);
}

namespace glsl {

inline constexpr snippet acne_free_bias{
    .name = "acne_free_bias",
    .summary = "bias without acne, from slope, reach and error",
    .exactness = tier::b,
    .operations = 4,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_bias: bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
UMBRAGE_HIGHP float umbrage_acne_free_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float reach,
                                           UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias =
        reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
)GLSL",
};

inline constexpr snippet acne_free_disc_bias{
    .name = "acne_free_disc_bias",
    .summary = "bias without acne, for filters that read a disc",
    .exactness = tier::c,
    .operations = 13,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_disc_bias: bias in depth without shadow acne for a disc, 0.0 to 1.0
//   slope   change of depth per texel, in x and y
//   radius  distance to the disc's farthest point, in texels
//   error   largest error of a decoded depth towards the light
UMBRAGE_HIGHP float umbrage_acne_free_disc_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float radius,
                                                UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = slope.x * slope.x + slope.y * slope.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside =
        (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
)GLSL",
};

inline constexpr snippet peter_panning_distance{
    .name = "peter_panning_distance",
    .summary = "depth within which a bias detaches shadows (peter-panning)",
    .exactness = tier::b,
    .operations = 4,
    .needs = list<&acne_free_bias>,
    .source = R"GLSL(
// umbrage_peter_panning_distance: depth, 0.0 to 1.0, within which casters lose their shadow or part of it
//   bias          bias of the receiver, in depth
//   caster_slope  change of the caster's depth per texel
//   reach         filter radius, in texels
UMBRAGE_HIGHP float umbrage_peter_panning_distance(UMBRAGE_HIGHP float bias, UMBRAGE_HIGHP vec2 caster_slope,
                                       UMBRAGE_HIGHP float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
)GLSL",
};

inline constexpr const snippet* acne_free_snippets[]{&acne_free_bias, &acne_free_disc_bias, &peter_panning_distance};

}  // namespace glsl
}  // namespace umbrage
