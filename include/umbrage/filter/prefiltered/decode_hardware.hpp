// SPDX-License-Identifier: MIT
//
// Decoding of variance and exponential variance shadow maps (VSM, EVSM) at the lowest GPU cost. It uses filtering by
// the sampler, the GPU's own exp2 and division, fused sums, and a reduction of light bleeding. Results are within a
// bound, not bit-exact.
//
//     float lit = umbrage::decode_vsm_hardware(held, receiver, 1e-6f, 0.2f);  // held: from encode_deviation
//     lit = umbrage::decode_evsm2_hardware(moments, receiver, exponent, deviation, 0.2f);
//
// Mean and deviation are filtered directly. No difference of squares is left that rounding could cancel.
// See also: vsm.hpp, evsm.hpp.
#pragma once

#include <cmath>

#include <glm/common.hpp>

#include <umbrage/filter/prefiltered/evsm.hpp>
#include <umbrage/filter/prefiltered/vsm.hpp>

namespace umbrage {

namespace detail {

/// True for |receiver| < 2^20, as for every depth. Other receivers are in shadow.
template <real T>
[[nodiscard]] constexpr bool is_depth(T receiver) {
    return !is_nan(receiver) && receiver < T(1048576) && receiver > T(-1048576);
}

}  // namespace detail

/// chebyshev() and reduce_light_bleeding() in one.
/// @param variance   a positive normal number
/// @param distance   from the mean to the receiver, no NaN. Not above 0: lit
/// @param amount     as for reduce_light_bleeding, 0 to 1/2
/// @formula          clamp((p - amount) / (1 - amount), 0, 1), p = variance / (variance + max(distance, 0)^2)
/// @exactness        C, within 1/524288: sum and product are off by half an ulp each, divisions by the 2.5 ulp that
///                   GPUs guarantee. The reduction doubles that
template <real T>
[[nodiscard]] constexpr T chebyshev_hardware(T variance, T distance, T amount) {
    const T beyond = distance > T(0) ? distance : T(0);
    const T p = variance / (variance + beyond * beyond);
    return glm::clamp((p - amount) / (T(1) - amount), T(0), T(1));
}

/// Visibility from filtered mean and deviation, with light bleeding reduced.
/// @param held           mean and twice the standard deviation, from encode_deviation, filtered; no NaN
/// @param receiver       receiver depth, with the bias already applied
/// @param min_variance   1e-7 or more
/// @param amount         as for reduce_light_bleeding, 0 to 1/2
/// @param cleared        cleared depth: 1, or 0 where depth is reversed
/// @edge                 NaN receiver, or |receiver| >= 2^20: 0
/// @formula              chebyshev_hardware(max((held.y / 2)^2, min_variance), d - held.x, amount),
///                       d = to_forward_depth(receiver)
/// @exactness            C, within 1/1024: a distance off by 2^-23 moves p by at most 0.65 2^-23 /
///                       sqrt(min_variance), and the reduction doubles that. chebyshev_hardware adds its own error
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] constexpr T decode_vsm_hardware(glm::vec<2, T> held, T receiver, T min_variance, T amount,
                                              T cleared = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T variance = (glm::max)(held.y * held.y * T(0.25), min_variance);
    return chebyshev_hardware(variance, to_forward_depth(receiver, cleared) - held.x, amount);
}

/// Visibility from a mean of encode_evsm2's texels, with light bleeding reduced.
/// @param m           mean of texels; no NaN
/// @param receiver    receiver depth in [0, 1], with the bias already applied; clamped
/// @param exponent    same as for the texels, at most 55
/// @param deviation   as for decode_evsm2, 0.005 or more
/// @param amount      as for reduce_light_bleeding, 0 to 0.3
/// @param cleared     cleared depth: 1, or 0 where depth is reversed
/// @edge              NaN receiver, or |receiver| >= 2^20: 0
/// @formula           chebyshev_hardware(max(m.y - m.x^2, (deviation w)^2), w - m.x, amount),
///                    w = exponential_warp(to_forward_depth(clamp(receiver, 0, 1)), exponent)
/// @exactness         C, within 1/64. GPUs guarantee exp2 of y to 3 + 2 |y| ulp. With y's own rounding on both
///                    sides, w is off by e = (5 + 4 exponent) 2^-23 of itself, and p by 0.65 e / deviation + e.
///                    Fusing the moments or not adds 2 (2^-24 / deviation^2 + 2^-21). The reduction divides both by
///                    1 - amount
/// @cite              Lauritzen, McCool: Layered variance shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] constexpr T decode_evsm2_hardware(glm::vec<2, T> m, T receiver, T exponent, T deviation, T amount,
                                                T cleared = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T w = exponential_warp(to_forward_depth(glm::clamp(receiver, T(0), T(1)), cleared), exponent),
            least = deviation * w;
    return chebyshev_hardware((glm::max)(m.y - m.x * m.x, least * least), w - m.x, amount);
}

/// Visibility from a mean of encode_evsm4's texels, with light bleeding reduced.
/// @param m           mean of texels; no NaN
/// @param receiver    as for decode_evsm2_hardware, and so are exponents, deviations and amount
/// @formula           the smaller of decode_evsm2_hardware's results for the two powers
/// @exactness         C, within 1/64, as decode_evsm2_hardware
template <real T>
[[nodiscard]] constexpr T decode_evsm4_hardware(glm::vec<4, T> m, T receiver, glm::vec<2, T> exponents,
                                                glm::vec<2, T> deviations, T amount, T cleared = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T d = to_forward_depth(glm::clamp(receiver, T(0), T(1)), cleared);
    const T w = exponential_warp(d, exponents.x), n = T(0) - exponential_warp(d, T(0) - exponents.y);
    const T least_w = deviations.x * w, least_n = deviations.y * n;
    const T a = chebyshev_hardware((glm::max)(m.y - m.x * m.x, least_w * least_w), w - m.x, amount);
    const T b = chebyshev_hardware((glm::max)(m.w - m.z * m.z, least_n * least_n), n - m.z, amount);
    return (glm::min)(a, b);
}

namespace glsl {

inline constexpr snippet chebyshev_hardware{
    .name = "chebyshev_hardware",
    .summary = "Chebyshev bound with light bleeding reduced",
    .exactness = tier::c,
    .within = 1.0f / 524288.0f,
    .source = R"GLSL(
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_chebyshev_hardware(UMBRAGE_HIGHP float variance, UMBRAGE_HIGHP float distance,
                                               UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float beyond = max(distance, 0.0);
    UMBRAGE_HIGHP float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_vsm_hardware{
    .name = "decode_vsm_hardware",
    .summary = "mean and deviation (VSM) to visibility, cheapest on GPUs",
    .exactness = tier::c,
    .within = 1.0f / 1024.0f,
    .needs = list<&chebyshev_hardware, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_decode_vsm_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   held           mean and twice the standard deviation of depths, filtered
//   receiver       receiver depth, bias applied
//   min_variance   1e-7 or more
//   amount         visibility that becomes 0.0, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_decode_vsm_hardware(UMBRAGE_HIGHP vec2 held, UMBRAGE_HIGHP float receiver,
                                                UMBRAGE_HIGHP float min_variance, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float variance = max(held.y * held.y * 0.25, min_variance);
    UMBRAGE_HIGHP float distance = umbrage_to_forward_depth(receiver) - held.x;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
)GLSL",
};

inline constexpr snippet decode_evsm2_hardware{
    .name = "decode_evsm2_hardware",
    .summary = "EVSM of two components to visibility, by the GPU's exp2",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&chebyshev_hardware, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm2_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
//   amount      visibility that becomes 0.0, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm2_hardware(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    UMBRAGE_HIGHP float w = exp2(exponent * (d * 2.0 - 1.0));
    UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_HIGHP float variance = max(m.y - m.x * m.x, least * least);
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
)GLSL",
};

inline constexpr snippet decode_evsm4_hardware{
    .name = "decode_evsm4_hardware",
    .summary = "EVSM of four components to visibility, by the GPU's exp2",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&chebyshev_hardware, &to_forward_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm4_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
//   amount       visibility that becomes 0.0, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm4_hardware(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float w = exp2(exponents.x * d);
    UMBRAGE_HIGHP float n = 0.0 - exp2((0.0 - exponents.y) * d);
    UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_HIGHP float growing = max(m.y - m.x * m.x, least.x * least.x);
    UMBRAGE_HIGHP float falling = max(m.w - m.z * m.z, least.y * least.y);
    UMBRAGE_HIGHP float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    UMBRAGE_HIGHP float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
)GLSL",
};

inline constexpr const snippet* decode_hardware_snippets[]{&chebyshev_hardware, &decode_vsm_hardware,
                                                           &decode_evsm2_hardware, &decode_evsm4_hardware};

}  // namespace glsl
}  // namespace umbrage
