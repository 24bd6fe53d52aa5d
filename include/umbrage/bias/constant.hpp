// SPDX-License-Identifier: MIT
//
// A receiver moved towards the light, which is what every bias in depth comes to.
//
//     float receiver = umbrage::biased(p.z, bias, filter.is_lit);  // p.z - bias, or p.z + bias where depth is reversed
//
#pragma once

#include <umbrage/core/compare.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// A bias in depth within its range: with 1 nothing is in shadow, so that no bias need be greater.
/// @return        0 below 2^-64, so that no denormal counts; 1 from 1 up, and for NaN
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_bias(T bias) {
    const T clamped = saturate(bias);
    return clamped < T(0x1p-64) ? T(0) : clamped;
}

/// A receiver moved towards the light; the direction of depth is the comparison's.
///
/// @param receiver   depth; NaN stays NaN, in shadow
/// @param bias       in depth: towards the light above 0, away from it below; of 2^64 and more, and NaN: none
/// @param is_lit     less_equal, greater_equal or comparison: comparison{encoding.direction}, or the is_lit of a filter
/// @return           the receiver that a filter compares
/// @formula          receiver - bias; receiver + bias where depth is reversed
/// @exactness        B, n = 1: one sum
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T biased(T receiver, T bias, const Compare& is_lit = {}) {
    constexpr T beyond(0x1p64);
    const bool some = !is_nan(bias) && bias < beyond && bias > -beyond;
    return is_lit.towards_light(receiver, some ? bias : T(0));
}

namespace glsl {

inline constexpr snippet clamp_bias{
    .name = "clamp_bias",
    .summary = "clamp of a bias to [0, 1], NaN to 1",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
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
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
UMBRAGE_HIGHP float umbrage_biased(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
)GLSL",
};

inline constexpr const snippet* constant_snippets[]{&clamp_bias, &biased};

}  // namespace glsl
}  // namespace umbrage
