// SPDX-License-Identifier: MIT
//
// Variance shadow maps (VSM): each texel stores depth and its square. Texels can be blurred, mipmapped and filtered by
// the sampler.
//
//     glm::vec2 texel = umbrage::encode_vsm(depth);  // a blurred map holds means of texels
//     float visibility = umbrage::decode_vsm(blurred, receiver, 1e-6f);
//
// It needs 32-bit floats. In 16-bit or four 8-bit channels, depth and its square are too coarse for a variance. Store
// mean and deviation there instead:
//
//     glm::vec2 held = umbrage::encode_deviation(blurred);  // each 0 to 1: two channels of 16 bits, or encode_rg<16>
//     glm::vec2 moments = umbrage::decode_deviation(held);
//
// A mean of these values is not a mean of depths: decode, blur, then encode again.
// Also called: VSM, variance shadow maps (encode_vsm, decode_vsm).
// See also: evsm.hpp and msm.hpp, which have less light bleeding.
#pragma once

#include <cmath>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/prefiltered/chebyshev.hpp>

namespace umbrage {

/// Texel of a variance shadow map: depth and its square.
/// @param depth     in [0, 1]; clamped
/// @param cleared   cleared depth: 1, or 0 where depth is reversed
/// @edge            NaN: (1, 1), as the far plane and a cleared texel
/// @formula         (d, d^2), d = to_forward_depth
/// @exactness       B, n = 3
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<2, T> encode_vsm(T depth, T cleared = T(1)) {
    const T d = to_forward_depth(saturate(depth, cleared), cleared);
    return {d, d * d};
}

/// Visibility from a mean of texels of a variance shadow map.
/// @param m              mean of texels
/// @param receiver       receiver depth, with the bias already applied
/// @param min_variance   >= 0; 1e-6 for 32-bit floats. It covers the variance that slopes and rounding add. Without it,
///                       surfaces shadow themselves
/// @param cleared        cleared depth: 1, or 0 where depth is reversed
/// @return               visibility before reduce_light_bleeding: at least the lit fraction, minus chebyshev's error
/// @edge                 NaN receiver: 0
/// @formula              chebyshev(m, to_forward_depth(receiver), min_variance)
/// @exactness            C, n = 13: a division. S is chebyshev's
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_vsm(glm::vec<2, T> m, T receiver, T min_variance, T cleared = T(1)) {
    return chebyshev(m, to_forward_depth(receiver, cleared), min_variance);
}

/// Mean and deviation from the two moments of depth.
/// @param m         mean of the depths, mean of their squares
/// @return          mean and twice the standard deviation, each in [0, 1] for depths in [0, 1]
/// @edge            NaN: the deviation is 0
/// @formula         (m.x, 2 sqrt(max(m.y - m.x^2, 0)))
/// @exactness       C, n = 7: a root. Where twice the bound of m.y - m.x^2 exceeds it, within 2 sqrt(m.y - m.x^2 +
///                  that bound)
template <real T>
[[nodiscard]] glm::vec<2, T> encode_deviation(glm::vec<2, T> m) {
    const T variance = m.y - m.x * m.x;
    return {m.x, T(2) * std::sqrt(!is_nan(variance) && variance > T(0) ? variance : T(0))};
}

/// Two moments of depth from mean and deviation.
/// @param held      mean and twice the standard deviation, as stored
/// @return          mean of the depths, mean of their squares
/// @formula         (mean, mean^2 + (deviation / 2)^2)
/// @exactness       B, n = 5
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> decode_deviation(glm::vec<2, T> held) {
    const T half = held.y * T(0.5);
    return {held.x, held.x * held.x + half * half};
}

/// Two moments of depth from four 8-bit channels. These hold mean and deviation, both written by encode_rg<16>.
/// @param c         as sampled, k / 255
/// @return          mean of the depths, mean of their squares. Both channels decode to the upper end of the
///                  quantization step, so nothing gets darker by being stored
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
    .summary = "depth to a texel of a variance shadow map (VSM)",
    .exactness = tier::b,
    .operations = 3,
    .needs = list<&saturate, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_vsm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2(d, d * d);
}
)GLSL",
};

inline constexpr snippet decode_vsm{
    .name = "decode_vsm",
    .summary = "mean of VSM texels to visibility",
    .exactness = tier::c,
    .operations = 13,
    .needs = list<&chebyshev, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
)GLSL",
};

inline constexpr snippet encode_deviation{
    .name = "encode_deviation",
    .summary = "two moments of depth (VSM) to mean and deviation",
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
    .summary = "mean and deviation to two moments of depth (VSM)",
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
    .summary = "mean and deviation in RGBA8 to two moments (VSM)",
    .exactness = tier::b,
    .operations = 21,
    .needs = list<&decode_deviation, &decode_rg<16>>,
    .source = R"GLSL(
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
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
