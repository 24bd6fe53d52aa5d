// SPDX-License-Identifier: MIT
//
// Variance shadow maps: a texel holds depth and its square, which may be blurred, halved and filtered by the sampler.
//
//     glm::vec2 texel = umbrage::encode_vsm(depth);  // blur and so on are means of texels
//     float visibility = umbrage::decode_vsm(blurred, receiver, 1e-6f);
//
// Needs floats of 32 bits. For targets of 16 bits, or of four times 8, hold mean and deviation instead: of depth and
// its square too little is left there to take a variance from.
//
//     glm::vec2 held = umbrage::encode_deviation(blurred);  // each 0 to 1: two channels of 16 bits, or encode_rg<16>
//     glm::vec2 moments = umbrage::decode_deviation(held);
//
// A mean of held values is no mean of depths: decode, blur, encode.
#pragma once

#include <cmath>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/prefiltered/chebyshev.hpp>

namespace umbrage {

/// @param depth     clamped to [0, 1]; NaN counts as far, as a cleared texel does: (1, 1)
/// @param cleared   1, or 0 where depth is reversed
/// @formula         (d, d^2), d = to_forward_depth
/// @exactness       B, n = 3
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<2, T> encode_vsm(T depth, T cleared = T(1)) {
    const T d = to_forward_depth(saturate(depth, cleared), cleared);
    return {d, d * d};
}

/// @param m              mean of texels
/// @param receiver       depth, biased; NaN is in shadow
/// @param min_variance   >= 0; 1e-6 for floats of 32 bits: variance that a slope or rounding brings, without which
///                       surfaces shadow themselves
/// @return               visibility before reduce_light_bleeding: at least the lit share, less chebyshev's error
/// @formula              chebyshev(m, to_forward_depth(receiver), min_variance)
/// @exactness            C, n = 13: a division. S is chebyshev's
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_vsm(glm::vec<2, T> m, T receiver, T min_variance, T cleared = T(1)) {
    return chebyshev(m, to_forward_depth(receiver, cleared), min_variance);
}

/// @param m         mean of the depths, mean of their squares
/// @return          mean and twice the standard deviation, for depths in [0, 1] each 0 to 1; the latter 0 for NaN
/// @formula         (m.x, 2 sqrt(max(m.y - m.x^2, 0)))
/// @exactness       C, n = 7: a root. Where twice the bound of m.y - m.x^2 is above it, within 2 sqrt(m.y - m.x^2 +
///                  that bound)
template <real T>
[[nodiscard]] glm::vec<2, T> encode_deviation(glm::vec<2, T> m) {
    const T variance = m.y - m.x * m.x;
    return {m.x, T(2) * std::sqrt(!is_nan(variance) && variance > T(0) ? variance : T(0))};
}

/// @param held      mean and twice the standard deviation, as stored
/// @return          mean of the depths, mean of their squares
/// @formula         (mean, mean^2 + (deviation / 2)^2)
/// @exactness       B, n = 5
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> decode_deviation(glm::vec<2, T> held) {
    const T half = held.y * T(0.5);
    return {held.x, held.x * held.x + half * half};
}

/// Mean and deviation of four channels of 8 bits, each as encode_rg<16> has it.
/// @param c         as sampled, k / 255
/// @return          the mean of the depths, the mean of their squares: mean and deviation of the upper edges of their
///                  codes, so that nothing gets darker by being stored
/// @formula         decode_deviation(decode_rg<16>(c.xy), decode_rg<16>(c.zw))
/// @exactness       B, n = 21
template <real T>
[[nodiscard]] glm::vec<2, T> decode_deviation_rgba8(glm::vec<4, T> c) {
    return decode_deviation(
        glm::vec<2, T>(decode_rg<16>(glm::vec<2, T>(c.x, c.y), T(1)), decode_rg<16>(glm::vec<2, T>(c.z, c.w), T(1))));
}

namespace glsl {

inline constexpr snippet encode_vsm{
    .name = "encode_vsm",
    .summary = "depth to a texel of a variance shadow map",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&saturate, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_vsm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2(d, d * d);
}
)GLSL",
};

inline constexpr snippet decode_vsm{
    .name = "decode_vsm",
    .summary = "mean of texels of a variance shadow map to visibility",
    .exactness = tier::c,
    .operations = 13,
    .needs = list<&chebyshev, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
)GLSL",
};

inline constexpr snippet encode_deviation{
    .name = "encode_deviation",
    .summary = "depth's two moments to mean and deviation",
    .exactness = tier::c,
    .operations = 7,
    .source = R"GLSL(
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
UMBRAGE_HIGHP vec2 umbrage_encode_deviation(UMBRAGE_HIGHP vec2 m) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = m.y - m.x * m.x;
    return vec2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
)GLSL",
};

inline constexpr snippet decode_deviation{
    .name = "decode_deviation",
    .summary = "mean and deviation to depth's two moments",
    .exactness = tier::b,
    .operations = 5,
    .source = R"GLSL(
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation(UMBRAGE_HIGHP vec2 held) {
    UMBRAGE_HIGHP float half_of_it = held.y * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = held.x * held.x + half_of_it * half_of_it;
    return vec2(held.x, square);
}
)GLSL",
};

inline constexpr snippet decode_deviation_rgba8{
    .name = "decode_deviation_rgba8",
    .summary = "mean and deviation in four channels to depth's two moments",
    .exactness = tier::b,
    .operations = 21,
    .needs = list<&decode_deviation, &decode_rg<16>>,
    .source = R"GLSL(
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation_rgba8(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP float mean = umbrage_decode_rg16(vec2(c.x, c.y), 1.0);
    UMBRAGE_HIGHP float deviation = umbrage_decode_rg16(vec2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2(mean, deviation));
}
)GLSL",
};

inline constexpr const snippet* vsm_snippets[]{&encode_vsm, &decode_vsm, &encode_deviation, &decode_deviation,
                                               &decode_deviation_rgba8};

}  // namespace glsl
}  // namespace umbrage
