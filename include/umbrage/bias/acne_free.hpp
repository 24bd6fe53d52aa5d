// SPDX-License-Identifier: MIT
//
// The smallest bias with which no plane shadows itself, from the plane's slope in the map, how far the filter reads and
// how the map is stored.
//
//     umbrage::filters::box filter{.radius = 2};
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);  // of depth, a texel
//     float bias = umbrage::acne_free_bias(slope, filter, umbrage::rg<11>{});
//     float visibility = filter(fetch, glm::vec2(p), umbrage::biased(p.z, bias, filter.is_lit));
//
// A filter compares a receiver with depths of its plane at centers of texels that lie up to its reach away, in x and in
// y: there the plane may be nearer by reach (|a| + |b|), and what is stored of it nearer still by the encoding's error.
// That much is needed, and no more: with 9/10 of it some receiver is dark.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/filter/filter.hpp>

namespace umbrage {

/// Texels that a reach grows by where the depth pass moves vertices to a grid, as rasterizers do.
/// @tparam SubTexelBits   of the grid: Direct3D has 8, Vulkan at least 4 (subPixelPrecisionBits), OpenGL at least 4
///                        (SUBPIXEL_BITS); WebGL, WebGPU and Metal state none
/// @formula               4 times the greatest move, half a step of 2^-SubTexelBits texel
template <real T, int SubTexelBits = 8>
inline constexpr T rasterizer_snap = T(2) / T(1 << SubTexelBits);

/// The smallest bias in depth without acne, for filters that read whole rows and columns.
///
/// @param slope   change of the receiver's depth from one texel to the next, in x and y: plane_slope, receiver_plane
/// @param reach   of the filter, texels; with coordinates that round, 2^-12 more for 4096 texels, and in proportion;
///                rasterizer_snap more where a rasterizer has moved vertices
/// @param error   how far a decoded depth may lie before the true one: decoding_error::below, where depth is reversed
///                above; of a UNORM depth texture 1/2 / (2^bits - 1)
/// @return        0 .. 1; 1, with which nothing is in shadow, for slopes and reaches that are infinite, and for NaN
/// @formula       reach (|slope.x| + |slope.y|) + error + 2^-23, the last for rounding in binary32 of depth once it is
///                there; what a matrix in floats lost of it before, some 2^-22 of a z/w near 1, is to be added to error
/// @detaches      casters nearer to the receiver than peter_panning_distance() lose their shadow
/// @exactness     B, n = 4
template <real T>
[[nodiscard]] constexpr T acne_free_bias(glm::vec<2, T> slope, T reach, T error) {
    const T sum = (slope.x < T(0) ? -slope.x : slope.x) + (slope.y < T(0) ? -slope.y : slope.y);
    return clamp_bias(reach * sum + (error + T(0x1p-23)));
}

/// The smallest bias in depth without acne, for filters that read a disc.
///
/// @param slope, error   as for acne_free_bias
/// @param radius         from the receiver to the farthest point, texels; the texel that a point falls into lies up to
///                       half a texel, and 1/128 for the points' rounding, farther
/// @return               0 .. 1; 1 for what is infinite, and for NaN
/// @formula              radius |slope| + (1/2 + 1/128) (|slope.x| + |slope.y|) + error + 2^-23
/// @exactness            C, n = 13: a square root
template <real T>
[[nodiscard]] T acne_free_disc_bias(glm::vec<2, T> slope, T radius, T error) {
    const T sum = std::abs(slope.x) + std::abs(slope.y);
    const T length = std::sqrt(slope.x * slope.x + slope.y * slope.y);
    return clamp_bias(radius * length + (sum * T(0.5078125) + (error + T(0x1p-23))));
}

/// The smallest bias for a filter over a map of an encoding, whose direction of depth says which of its errors counts.
/// @param more   what the reach is to grow by, texels: rasterizer_snap, rounding of coordinates
[[nodiscard]] constexpr float acne_free_bias(glm::vec2 slope, const known_filter auto& filter,
                                             const known_encoding auto& encoding, float more = 0.0f) {
    const decoding_error both = encoding.error();
    const auto error = float(encoding.direction == depth_direction::forward ? both.below : both.above);
    if constexpr (requires { filter.farthest_point(); })
        return acne_free_disc_bias(slope, filter.farthest_point() + more, error);
    else return acne_free_bias(slope, filter.reach() + more, error);
}

/// Depth before a receiver within which a caster's shadow is lost, wholly or in part.
///
/// @param bias           of the receiver, in depth
/// @param caster_slope   of the caster's depth, a texel; |slope.x| + |slope.y| of a caster that faces the light is 0
/// @param reach          of the filter, texels
/// @return               0 .. 1: casters at least so far before the receiver shadow it as without bias; 1 for what is
///                       infinite, and for NaN
/// @formula              bias + reach (|caster_slope.x| + |caster_slope.y|) + 2^-23. On a floor beside a wall that
///                       stands square to it light leaks in for bias sin(t), t between the floor's normal and the
///                       light: in world units at most sqrt(2) reach texel tan(t) sin(t)
/// @exactness            B, n = 4
template <real T>
[[nodiscard]] constexpr T peter_panning_distance(T bias, glm::vec<2, T> caster_slope, T reach) {
    return acne_free_bias(caster_slope, reach, bias);
}

namespace glsl {

inline constexpr snippet acne_free_bias{
    .name = "acne_free_bias",
    .summary = "smallest bias without acne, for a slope, a reach and an encoding's error",
    .exactness = tier::b,
    .operations = 4,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
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
    .summary = "smallest bias without acne, for filters that read a disc",
    .exactness = tier::c,
    .operations = 13,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
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
    .summary = "depth before a receiver within which its bias loses a caster's shadow",
    .exactness = tier::b,
    .operations = 4,
    .needs = list<&acne_free_bias>,
    .source = R"GLSL(
// umbrage_peter_panning_distance: a caster nearer to the receiver loses its shadow, or a part of it; depth, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
UMBRAGE_HIGHP float umbrage_peter_panning_distance(UMBRAGE_HIGHP float bias, UMBRAGE_HIGHP vec2 caster_slope,
                                       UMBRAGE_HIGHP float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
)GLSL",
};

inline constexpr const snippet* acne_free_snippets[]{&acne_free_bias, &acne_free_disc_bias, &peter_panning_distance};

}  // namespace glsl
}  // namespace umbrage
