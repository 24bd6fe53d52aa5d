// SPDX-License-Identifier: MIT
//
// Hausdorff moment problem for moment shadow maps (MSM): depths are known to lie in [-1, 1], so less light bleeds than
// with `decode_msm`. It needs 32-bit floats.
//
//     float visibility = umbrage::decode_msm_hausdorff(blurred, receiver, umbrage::msm_bias_32);
//
// A floor that falls away from the light darkens a little where it ends before cleared texels. The blur there holds
// only the floor's nearer side: depths nearer to the light than the receiver. `decode_msm` misses them, since it takes
// the cleared texels for spread about a mean. A bias for the blur's radius removes the darkening.
// Also called: Hausdorff MSM (decode_msm_hausdorff).
#pragma once

#include <umbrage/filter/prefiltered/msm.hpp>

namespace umbrage {

/// Smallest fraction of depths nearer to the light than the receiver, over distributions of depths in [-1, 1].
///
/// The distribution has four depths: both ends, the receiver's depth z and one more, f.
/// This holds where one of moment_atoms lies outside [-1, 1].
/// @param b         moments, biased
/// @param z         the receiver's depth on [-1, 1]
/// @return          the fraction, 0 to 1; 0 at the near end
/// @edge            no four such depths have these moments: negative
/// @formula         D = b2 - b1^2, L = b3 - b1 b2, F = b4 - b2^2, w = 1 - b2, x = z - b1, d = L + w x,
///                  g = F - D w - (z + b1) L, f = b1 + g / d, p = d (1 + f), q = d (1 - f), k = w g + L d. The share at
///                  -1 is ((1 + z) (d D + g (1 - b1)) - k) / (2 (1 + z) p). That at 1 has the sign of
///                  ((1 - z) (d D - g (1 + b1)) + k) q. That at f is d^4 / (p q (x d - g)); f is nearer to the light
///                  than the receiver where d > 0. These are weights of interpolation in central moments, where few
///                  digits cancel
/// @exactness       C, within 1/1048576 as written: two divisions. No division decides which depths there are. In
///                  binary32 off, to first order, by at most 24 2^-24 (s + 1 / ((1 + z) (1 - f^2)) + 1 / |z - f|), s
///                  the sum of the absolute coefficients of the polynomial of degree 4 whose mean is the share: 1 at
///                  -1, twice 0 at f, 0 at z and 1. Where f < z it is: twice 0 at f, 0 at -1, 1 at z and 1.
///                  Rounding up to d and g has the effect of moments that are off by (1, 1, 8, 23) 2^-24. The share
///                  does not change with f to first order. The steps that follow are off by 8 2^-24 of 1 / (1 + f),
///                  1 / (1 - f), 1 / |z - f| or 1 / ((1 + z) (1 + f)). No bound on s holds for all moments: a bias of
///                  (0, y, 0, y) is one of depths -1, 0 and 1, no help where f is 0
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T hausdorff_share(glm::vec<4, T> b, T z) {
    const T variance = b.y - b.x * b.x, third = b.z - b.x * b.y, fourth = b.w - b.y * b.y, rest = T(1) - b.y;
    const T x = z - b.x, d = third + rest * x, g = (fourth - variance * rest) - (z + b.x) * third;
    const T p = d * (T(1) + b.x) + g, q = d * (T(1) - b.x) - g, k = rest * g + third * d, square = d * d;
    const T first = (T(1) + z) * (d * variance + g * (T(1) - b.x)) - k;
    const T last = (T(1) - z) * (d * variance - g * (T(1) + b.x)) + k;
    const T end = first / (T(2) * ((T(1) + z) * p)), other = (square * square) / (p * (q * (x * d - g)));
    const T share = end + detail::pick(d > T(0), other, T(0));
    const auto four = int(first * p > T(0)) & int(last * q > T(0)) & int(p * q > T(0)) & int(share >= T(0));
    const T known = detail::pick(bool(four), detail::pick(share < T(1), share, T(1)), T(-1));
    return detail::pick(z <= T(-1), T(0), known);
}

namespace detail {

/// decode_msm_hausdorff for biased moments, decode_msm's result, and a depth that grows with distance.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T lit_within(T plain, glm::vec<4, T> b, T d) {
    const T share = hausdorff_share(b, moment_depth(d));
    return pick(bool(int(!is_nan(d)) & int(share >= T(0))), T(1) - share, plain);
}

}  // namespace detail

/// Visibility from a mean of four moments of depths in [-1, 1].
/// @param b         mean of texels
/// @param receiver  receiver depth in [0, 1], with the bias already applied; clamped
/// @param bias      msm_bias_32
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @return          visibility in [0, 1]: at least the lit fraction, minus bias.x and rounding. At most decode_msm's
///                  result, except for rounding
/// @edge            receiver at the near end: 1. NaN receiver: 0. Moments of fewer than three depths, or NaN: as
///                  decode_msm
/// @formula         1 - hausdorff_share where that is not negative, else decode_msm
/// @exactness       C, within 1/64 as written
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015
template <real T>
[[nodiscard]] T decode_msm_hausdorff(glm::vec<4, T> b, T receiver, glm::vec<2, T> bias, T cleared = T(1)) {
    return detail::lit_within(decode_msm(b, receiver, bias, cleared), bias_moments(b, bias),
                              to_forward_depth(receiver, cleared));
}

namespace glsl {

inline constexpr snippet hausdorff_share{
    .name = "hausdorff_share",
    .summary = "smallest fraction of nearer depths, for depths on [-1, 1]",
    .exactness = tier::c,
    .within = 1.0f / 1048576.0f,
    .as_written = true,
    .source = R"GLSL(
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float fourth = b.w - b.y * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float rest = 1.0 - b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = z - b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = third + rest * x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float g = (fourth - variance * rest) - (z + b.x) * third;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = d * (1.0 + b.x) + g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float q = d * (1.0 - b.x) - g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float k = rest * g + third * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    UMBRAGE_HIGHP float square = d * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = p * (q * (x * d - g));
    UMBRAGE_HIGHP float end = first / (2.0 * ((1.0 + z) * p));
    UMBRAGE_HIGHP float other = square * square / between;
    UMBRAGE_HIGHP float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
)GLSL",
};

inline constexpr snippet decode_msm_hausdorff{
    .name = "decode_msm_hausdorff",
    .summary = "mean of MSM texels to visibility, for depths on [-1, 1]",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .as_written = true,
    .needs = list<&bias_moments, &decode_msm, &to_forward_depth, &hausdorff_share>,
    .source = R"GLSL(
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
UMBRAGE_HIGHP float umbrage_decode_msm_hausdorff(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver,
                                                 UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float plain = umbrage_decode_msm(b, receiver, bias);
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    UMBRAGE_HIGHP float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    UMBRAGE_HIGHP float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr const snippet* hausdorff_snippets[]{&hausdorff_share, &decode_msm_hausdorff};

}  // namespace glsl
}  // namespace umbrage
