// SPDX-License-Identifier: MIT
//
// Chebyshev's one-sided inequality for variance shadow maps (VSM): an upper bound on visibility from the mean and
// variance of depths. Also a reduction of light bleeding.
//
//     float lit = umbrage::chebyshev(moments, receiver, 1e-6f);
//     lit = umbrage::reduce_light_bleeding(lit, 0.2f);
//
// Before the reduction, no receiver is darker than its lit fraction of depths. Light bleeds behind two casters, at
// distance a between them and b behind the farther one, by up to (a / (a + 2 b))^2.
// Also called: ChebyshevUpperBound (chebyshev); light bleeding reduction, linstep (reduce_light_bleeding).
#pragma once

#include <glm/vec2.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/filter/prefiltered/exp2.hpp>

namespace umbrage {

/// Depth that grows with the distance from the light, in either depth direction of the map. Prefiltered maps store it.
/// @param depth     depth in [0, 1]
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @formula         1 - depth where depth is reversed, else depth
/// @exactness       B, n = 1
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T to_forward_depth(T depth, T cleared = T(1)) {
    return detail::pick(cleared < T(0.5), T(1) - depth, depth);
}

/// Upper bound on the fraction of depths that are at the receiver's depth or farther.
///
/// @param m              mean of the depths, mean of their squares
/// @param receiver       receiver depth, on the same scale
/// @param min_variance   >= 0, no NaN. Must be above the variance that rounding gives to equal depths
/// @return               visibility in [0, 1]
/// @edge                 NaN in m or receiver: 0. Depths without variance nearer to the light than the receiver, and
///                       min_variance 0: 0
/// @formula              receiver <= m.x ? 1 : v / (v + (receiver - m.x)^2), v = max(m.y - m.x^2, min_variance)
/// @exactness            C, n = 11: a division. S = V (V + (receiver + |m.x|)^2) / (v + (receiver - m.x)^2)^2, V = m.y
///                       + m.x^2 or min_variance. For depths up to 1, within (1 / (4 min_variance) + 4) 2^-24 of the
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

/// Visibility above a threshold, stretched to [0, 1]. Removes light bleeding, but makes shadow edges darker and harder.
/// @param visibility  in [0, 1]
/// @param amount      visibility that becomes 0, in [0, 1]; 0.2 is usual
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
    .summary = "depth that grows with the distance from the light",
    .exactness = tier::b,
    .operations = 1,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
)GLSL",
};

inline constexpr snippet chebyshev{
    .name = "chebyshev",
    .summary = "upper bound on visibility from mean and variance",
    .exactness = tier::c,
    .operations = 11,
    .source = R"GLSL(
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
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
    .summary = "visibility above a threshold, stretched to [0, 1]",
    .exactness = tier::c,
    .operations = 5,
    .source = R"GLSL(
// umbrage_reduce_light_bleeding: visibility from amount to 1.0, stretched to 0.0 to 1.0
UMBRAGE_HIGHP float umbrage_reduce_light_bleeding(UMBRAGE_HIGHP float visibility, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
)GLSL",
};

inline constexpr const snippet* chebyshev_snippets[]{&to_forward_depth, &chebyshev, &reduce_light_bleeding};

}  // namespace glsl
}  // namespace umbrage
