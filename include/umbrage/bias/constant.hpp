// SPDX-License-Identifier: MIT
//
// Constant depth bias: a receiver moved towards the light. All depth biases end in this step.
//
//     float receiver = umbrage::biased(p.z, bias, filter.direction);  // p.z - bias, or p.z + bias for reversed depth
//
// Also called: shadow bias, depth bias, epsilon (biased).
// See also: acne_free.hpp for the size of the bias; rasterizer.hpp to bias the casters instead.
//
#pragma once

#include <umbrage/core/compare.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Depth bias clamped to [0, 1]. A bias of 1 already removes all shadows.
/// @edge          below 2^-64: 0, so that no denormal counts. NaN: 1
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_bias(T bias) {
    const T clamped = saturate(bias);
    return clamped < T(0x1p-64) ? T(0) : clamped;
}

/// Receiver moved towards the light.
///
/// @param receiver   receiver depth
/// @param bias       depth units: above 0 towards the light, below 0 away from it
/// @param direction  direction of depth: that of the clip space
/// @return           receiver depth for the filter's comparison
/// @edge             NaN receiver: NaN, in shadow. Bias NaN, or of magnitude 2^64 or more: not applied
/// @formula          receiver - bias; receiver + bias for reversed depth
/// @exactness        B, n = 1: one sum
template <real T>
[[nodiscard]] constexpr T biased(T receiver, T bias, depth_direction direction = depth_direction::forward) {
    constexpr T beyond(0x1p64);
    const bool some = !is_nan(bias) && bias < beyond && bias > -beyond;
    const T by = some ? bias : T(0);
    return direction == depth_direction::forward ? receiver - by : receiver + by;
}

namespace glsl {

inline constexpr snippet clamp_bias{
    .name = "clamp_bias",
    .summary = "clamp of a bias to [0, 1]; NaN becomes 1",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias < 1.0 ? (bias >= least ? bias : 0.0) : 1.0;
}
)GLSL",
};

inline constexpr snippet biased{
    .name = "biased",
    .summary = "receiver moved towards the light",
    .exactness = tier::b,
    .operations = 1,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
UMBRAGE_HIGHP float umbrage_biased(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
)GLSL",
};

inline constexpr const snippet* constant_snippets[]{&clamp_bias, &biased};

}  // namespace glsl
}  // namespace umbrage
