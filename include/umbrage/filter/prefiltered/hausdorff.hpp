// SPDX-License-Identifier: MIT
//
// Four moments of depths that are known to lie in [-1, 1]: what decode_msm takes for outside of it goes to its end, and
// less light bleeds through. For floats of 32 bits.
//
//     float visibility = umbrage::decode_msm_hausdorff(blurred, receiver, umbrage::msm_bias_32);
//
#pragma once

#include <umbrage/filter/prefiltered/msm.hpp>

namespace umbrage {

/// Share of depths before the receiver where one of moment_atoms lies outside [-1, 1]: the least that depths of [-1, 1]
/// have, with one of them at the near end, one at the far end, one at the receiver's, and one more.
///
/// @param b         moments, biased
/// @param z         the receiver's depth on [-1, 1]
/// @formula         d = b3 - b1 - z (b2 - 1), f = (b4 - b2 - z (b3 - b1)) / d, s = z + f, p = z f; the share at -1 is
///                  (b3 - (1 + s) b2 + (s + p) b1 - p) / (-2 (1 + z) (1 + f)), that at f, where it lies before the
///                  receiver, d / ((f^2 - 1) (f - z))
/// @exactness       C: divisions
template <real T>
[[nodiscard]] T hausdorff_share(glm::vec<4, T> b, T z) {
    const T d = (b.z - b.x) - z * (b.y - T(1));
    const T f = ((b.w - b.y) - z * (b.z - b.x)) / d;
    const T s = z + f, p = z * f;
    const T end = ((b.z - (T(1) + s) * b.y) + ((s + p) * b.x - p)) / (T(-2) * ((T(1) + z) * (T(1) + f)));
    const T other = d / ((f * f - T(1)) * (f - z));
    return end + (f < z ? other : T(0));
}

/// @param b         mean of texels
/// @param receiver  depth, biased; outside [0, 1] the nearer end counts, the near end is lit; NaN is in shadow
/// @param bias      msm_bias_32
/// @return          visibility, 0 to 1, no more than decode_msm's but for rounding: at least the lit share, less bias.x
///                  and rounding, of whose quotients no bound is known. Where moments are those of fewer than three
///                  depths, and of NaN: as decode_msm
/// @formula         decode_msm where both of moment_atoms lie in [-1, 1], else 1 - hausdorff_share
/// @exactness       C: within 1/64 in a shader, but for receivers nearer than 2^-20 to depth 0, where 1 + z0 cancels:
///                  0.95 for 1 was seen there
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015
template <real T>
[[nodiscard]] T decode_msm_hausdorff(glm::vec<4, T> b, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    const T d = forward_depth(receiver, far), plain = decode_msm(b, receiver, bias, far);
    const T z = detail::moment_depth(d);
    const glm::vec<4, T> m = bias_moments(b, bias);
    const glm::vec<4, T> atoms = moment_atoms(m, z - m.x);
    const bool outside = std::abs(atoms.x + m.x) > T(1) || std::abs(atoms.y + m.x) > T(1);
    const T lit = z > T(-1) ? T(1) - hausdorff_share(m, z) : T(1);
    if (is_nan(d) || is_nan(lit) || std::abs(lit) > T(4294967296) || !detail::are_shares(atoms) || !outside)
        return plain;
    return lit > T(0) ? (lit < T(1) ? lit : T(1)) : T(0);
}

namespace glsl {

inline constexpr snippet hausdorff_share{
    .name = "hausdorff_share",
    .summary = "least share of depths before a receiver, of depths on [-1, 1]",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .source = R"GLSL(
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = (b.z - b.x) - z * (b.y - 1.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float n = (b.w - b.y) - z * (b.z - b.x);
    UMBRAGE_HIGHP float f = n / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float s = z + f;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = z * f;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float above = (b.z - (1.0 + s) * b.y) + ((s + p) * b.x - p);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float below = -2.0 * ((1.0 + z) * (1.0 + f));
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = (f * f - 1.0) * (f - z);
    UMBRAGE_HIGHP float end = above / below;
    UMBRAGE_HIGHP float other = d / between;
    return end + (f < z ? other : 0.0);
}
)GLSL",
};

inline constexpr snippet decode_msm_hausdorff{
    .name = "decode_msm_hausdorff",
    .summary = "mean of four moments of depths on [-1, 1] to visibility",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&bias_moments, &decode_msm, &forward_depth, &hausdorff_share, &moment_atoms>,
    .source = R"GLSL(
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
UMBRAGE_HIGHP float umbrage_decode_msm_hausdorff(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver,
                                                 UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float plain = umbrage_decode_msm(b, receiver, bias);
    UMBRAGE_HIGHP float d = umbrage_forward_depth(receiver);
    UMBRAGE_HIGHP float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    UMBRAGE_HIGHP vec4 m = umbrage_bias_moments(b, bias);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = z - m.x;
    UMBRAGE_HIGHP vec4 atoms = umbrage_moment_atoms(m, x);
    bool outside = abs(atoms.x + m.x) > 1.0 || abs(atoms.y + m.x) > 1.0;
    UMBRAGE_HIGHP float share = umbrage_hausdorff_share(m, z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float lit = z > -1.0 ? 1.0 - share : 1.0;
    bool known = outside && abs(atoms.z + atoms.w) <= 4294967296.0 && abs(lit) <= 4294967296.0;  // what is no NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr auto hausdorff_snippets = list<&hausdorff_share, &decode_msm_hausdorff>;

}  // namespace glsl
}  // namespace umbrage
