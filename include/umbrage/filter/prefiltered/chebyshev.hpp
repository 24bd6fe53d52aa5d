// SPDX-License-Identifier: MIT
//
// What mean and variance of depths say of how many of them are lit: the one-sided inequality of Chebyshev, and how to
// cut off the light that it lets through.
//
//     float lit = umbrage::chebyshev(moments, receiver, 1e-6f);
//     lit = umbrage::reduce_light_bleeding(lit, 0.2f);
//
// Before the cut no receiver is darker than the share of depths that light it. Behind casters that lie behind each
// other it is lighter: at a distance b behind the farther of two that are a apart by up to (a / (a + 2 b))^2.
#pragma once

#include <glm/vec2.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/filter/prefiltered/exp2.hpp>

namespace umbrage {

/// Depth that grows with the distance from the light, whichever way the map's does: prefiltered maps hold it.
/// @param cleared   1, or 0 where depth is reversed
/// @formula         1 - depth where depth is reversed, else depth
/// @exactness       B, n = 1
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T to_forward_depth(T depth, T cleared = T(1)) {
    return detail::pick(cleared < T(0.5), T(1) - depth, depth);
}

/// Share of depths that may be as far as the receiver or farther, at most.
///
/// @param m              mean of the depths, mean of their squares
/// @param receiver       on the same scale
/// @param min_variance   >= 0, no NaN; what rounding leaves of the variance of equal depths must stay below it
/// @return               visibility, 0 to 1; 0 where something is NaN, or where depths without variance lie before the
///                       receiver and min_variance is 0
/// @formula              receiver <= m.x ? 1 : v / (v + (receiver - m.x)^2), v = max(m.y - m.x^2, min_variance)
/// @exactness            C, n = 11: a division. S = V (V + (receiver + |m.x|)^2) / (v + (receiver - m.x)^2)^2, V = m.y
///                       + m.x^2 or min_variance; of depths up to 1 within (1 / (4 min_variance) + 4) 2^-24 of the
///                       formula in reals
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T chebyshev(glm::vec<2, T> m, T receiver, T min_variance) {
    const T difference = m.y - m.x * m.x;
    const T variance = detail::pick(difference > min_variance, difference, min_variance);
    const T distance = receiver - m.x;
    const T p = variance / (variance + distance * distance);
    const T dark = detail::pick(bool(int(p > T(0)) & int(!is_nan(p))), detail::pick(p < T(1), p, T(1)), T(0));
    return detail::pick(bool(int(receiver <= m.x) & int(!is_nan(receiver)) & int(!is_nan(m.x))), T(1), dark);
}

/// Visibility without its least values, stretched to 0 to 1: light that bleeds through is gone, shadows' edges are
/// darker and harder.
/// @param amount      what becomes 0, 0 to 1; 0.2 is usual
/// @formula           visibility > amount ? (visibility - amount) / (1 - amount) : 0
/// @exactness         C, n = 5: a division. S = (visibility + amount) (1 + amount) / (1 - amount)^2
template <real T>
[[nodiscard]] constexpr T reduce_light_bleeding(T visibility, T amount) {
    const bool above = !is_nan(visibility) && !is_nan(amount) && visibility > amount;
    return above ? (visibility - amount) / (T(1) - amount) : T(0);
}

namespace glsl {

inline constexpr snippet to_forward_depth{
    .name = "to_forward_depth",
    .summary = "depth that grows with distance",
    .exactness = tier::b,
    .operations = 1,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
)GLSL",
};

inline constexpr snippet chebyshev{
    .name = "chebyshev",
    .summary = "most that mean and variance let be lit",
    .exactness = tier::c,
    .operations = 11,
    .source = R"GLSL(
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_chebyshev(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                      UMBRAGE_HIGHP float min_variance) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float difference = m.y - m.x * m.x;
    UMBRAGE_HIGHP float variance = difference > min_variance ? difference : min_variance;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float distance = receiver - m.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = variance + distance * distance;
    UMBRAGE_HIGHP float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
)GLSL",
};

inline constexpr snippet reduce_light_bleeding{
    .name = "reduce_light_bleeding",
    .summary = "visibility without its least values",
    .exactness = tier::c,
    .operations = 5,
    .source = R"GLSL(
// umbrage_reduce_light_bleeding: visibility from amount to 1.0 stretched to 0.0 to 1.0: less light bleeds
UMBRAGE_HIGHP float umbrage_reduce_light_bleeding(UMBRAGE_HIGHP float visibility, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
)GLSL",
};

inline constexpr const snippet* chebyshev_snippets[]{&to_forward_depth, &chebyshev, &reduce_light_bleeding};

}  // namespace glsl
}  // namespace umbrage
