// SPDX-License-Identifier: MIT
//
// Exponential variance shadow maps (EVSM): each texel stores a power of depth and its square. With four components it
// also stores a negative power and its square. Less light bleeds than in VSM: only where both powers let it through.
//
//     const auto evsm = umbrage::make_evsm({.exponent = 40.0f});  // throws where floats would overflow
//     glm::vec4 texel = umbrage::encode_evsm4(depth, evsm.exponents);
//     float visibility = umbrage::decode_evsm4(blurred, receiver, evsm.exponents, evsm.deviations);
//
// Also called: EVSM, EVSM2, EVSM4 (make_evsm, encode_evsm4, decode_evsm4). See also: vsm.hpp, msm.hpp.
#pragma once

#include <cmath>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/filter/prefiltered/chebyshev.hpp>
#include <umbrage/filter/prefiltered/esm.hpp>

namespace umbrage {

/// Texel of two components: a power of depth and its square.
/// @param depth      in [0, 1]; clamped
/// @param exponent   0 to 55
/// @param cleared    cleared depth: 1, or 0 where depth is reversed
/// @edge             NaN: as the far plane and a cleared texel
/// @formula          (w, w^2), w = exponential_warp(to_forward_depth)
/// @exactness        B, n = 73
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<2, T> encode_evsm2(T depth, T exponent, T cleared = T(1)) {
    const T w = exponential_warp(to_forward_depth(saturate(depth, cleared), cleared), exponent);
    return {w, w * w};
}

/// Texel of four components: a growing and a falling power of depth, and their squares.
/// @param depth       in [0, 1]; clamped
/// @param exponents   exponents of the growing and the falling power, 0 to 55
/// @param cleared     cleared depth: 1, or 0 where depth is reversed
/// @edge              NaN: as the far plane and a cleared texel
/// @formula           (w, w^2, n, n^2), w = exponential_warp(d, exponents.x), n = -exponential_warp(d, -exponents.y)
/// @exactness         B, n = 73
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> encode_evsm4(T depth, glm::vec<2, T> exponents,
                                                                   T cleared = T(1)) {
    const T d = to_forward_depth(saturate(depth, cleared), cleared);
    const T w = exponential_warp(d, exponents.x), n = -exponential_warp(d, -exponents.y);
    return {w, w * w, n, n * n};
}

namespace detail {

/// chebyshev() of powers, with a minimum deviation relative to the receiver's power.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T warped_chebyshev(glm::vec<2, T> m, T w, T deviation) {
    const T least = deviation * w;
    return chebyshev(m, w, least * least);
}

}  // namespace detail

/// Visibility from a mean of texels of two components.
/// @param m          mean of texels
/// @param receiver   receiver depth in [0, 1], with the bias already applied; clamped
/// @param exponent   same as for the texels
/// @param deviation  minimum standard deviation, relative to the receiver's power. make_evsm computes it, from
///                   a minimum deviation of depth times 2 ln(2) exponent
/// @param cleared    cleared depth: 1, or 0 where depth is reversed
/// @return           visibility before reduce_light_bleeding: at least the lit fraction, minus chebyshev's error
/// @edge             NaN receiver: 0
/// @formula          chebyshev(m, w, (deviation w)^2), w = exponential_warp(to_forward_depth(saturate(receiver)))
/// @exactness        C, n = 229: a division. S is chebyshev's with S(w) for w. Within 2^-24 / deviation^2 + 2^-21 of
///                   the formula in reals of the same powers
/// @cite             Lauritzen, McCool: Layered variance shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_evsm2(glm::vec<2, T> m, T receiver, T exponent, T deviation,
                                                      T cleared = T(1)) {
    const T d = to_forward_depth(saturate(receiver, cleared), cleared);
    const T lit = detail::warped_chebyshev(m, exponential_warp(d, exponent), deviation);
    return detail::pick(is_nan(receiver), T(0), lit);
}

/// Visibility from a mean of texels of four components.
/// @param m           mean of texels
/// @param receiver    receiver depth in [0, 1], with the bias already applied; clamped
/// @param exponents   same as for the texels
/// @param deviations  minimum standard deviations, relative to the receiver's powers, from make_evsm
/// @param cleared     cleared depth: 1, or 0 where depth is reversed
/// @return            visibility before reduce_light_bleeding: at least the lit fraction, minus chebyshev's error
/// @edge              NaN receiver: 0
/// @formula           the smaller of decode_evsm2's results for the two powers
/// @exactness         C, n = 229: a division. S as decode_evsm2
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_evsm4(glm::vec<4, T> m, T receiver, glm::vec<2, T> exponents,
                                                      glm::vec<2, T> deviations, T cleared = T(1)) {
    const T d = to_forward_depth(saturate(receiver, cleared), cleared);
    const T a = detail::warped_chebyshev(glm::vec<2, T>(m.x, m.y), exponential_warp(d, exponents.x), deviations.x);
    const T b = detail::warped_chebyshev(glm::vec<2, T>(m.z, m.w), -exponential_warp(d, -exponents.y), deviations.y);
    return detail::pick(is_nan(receiver), T(0), detail::pick(a < b, a, b));
}

/// Settings of exponential variance shadow maps.
struct evsm_settings {
    float exponent = 40.0f;        ///< binary exponent of the growing power, at the far plane
    float falling = 8.0f;          ///< binary exponent of the falling power, at the near plane
    float least_deviation = 0.0f;  ///< minimum deviation of depth within a surface; 0: 1e-4, in 16 bits 1e-2
    float_store store = float_store::single;
};

/// Parameters for shaders and functions, from make_evsm.
struct evsm_parameters {
    glm::vec2 exponents{};   ///< exponents of the growing and the falling power; evsm2 uses only the first
    glm::vec2 deviations{};  ///< minimum deviations, relative to the receiver's powers
};

namespace detail {

/// Refuses an exponent with which powers or their squares would not be finite normal numbers.
inline void require_evsm_exponent(std::string_view function, std::string_view argument, float exponent,
                                  float_store store = float_store::single) {
    const bool single = store == float_store::single;
    require(exponent > 0.0f && exponent <= (single ? 55.0f : 7.99f), function, argument,
            single ? "above 0 and at most 55" : "above 0 and at most 7.99 in 16 bits", exponent);
}

/// True if squared distances of a deviation's size are normal numbers, and hardware flushes none to 0.
/// @param deviation  minimum deviation, relative to the receiver's power
/// @param falling    exponent of the falling power; 0 for the growing one
[[nodiscard]] inline bool holds_deviation(float deviation, float falling = 0.0f) {
    const float least_power = falling > 0.0f ? exp2_polynomial(-falling) : 1.0f;
    return is_finite(deviation) && deviation * least_power >= 0x1p-51f;  // its square may be below 2^-126
}

}  // namespace detail

/// Parameters from settings.
/// @throws std::invalid_argument   an exponent not above 0, or above 55 in 32 bits, 7.99 in 16: powers and squares must
///                                 be finite normal numbers. A minimum deviation below 0 or infinite, or so small that
///                                 squared distances of its size are not normal numbers, which hardware flushes to 0.
///                                 The default is large enough up to a falling exponent of 43
/// @formula   deviations = 2 ln(2) exponents least_deviation, the derivative of the power over the power
[[nodiscard]] inline evsm_parameters make_evsm(const evsm_settings& settings) {
    const float usual = settings.store == float_store::single ? 1e-4f : 1e-2f;
    constexpr auto function = "make_evsm";
    detail::require(is_finite(settings.least_deviation) && settings.least_deviation >= 0.0f, function,
                    "least_deviation", "finite, 0 or more", settings.least_deviation);
    const float least = settings.least_deviation > 0.0f ? settings.least_deviation : usual;
    const auto deviation = [&](float exponent, bool falls) {
        detail::require_evsm_exponent(function, falls ? "falling" : "exponent", exponent, settings.store);
        const float part = exponent * (1.38629436f * least);
        detail::require(detail::holds_deviation(part, falls ? exponent : 0.0f), function, "least_deviation",
                        "larger for this exponent", least);
        return part;
    };
    return {{settings.exponent, settings.falling},
            {deviation(settings.exponent, false), deviation(settings.falling, true)}};
}

namespace glsl {

inline constexpr snippet encode_evsm2{
    .name = "encode_evsm2",
    .summary = "depth to an EVSM texel of two components",
    .exactness = tier::b,
    .operations = 73,
    .needs = list<&saturate, &to_forward_depth, &exponential_warp>,
    .source = R"GLSL(
// umbrage_encode_evsm2: texel of two components, a power of depth and its square. NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_evsm2(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2(w, w * w);
}
)GLSL",
};

inline constexpr snippet encode_evsm4{
    .name = "encode_evsm4",
    .summary = "depth to an EVSM texel of four components",
    .exactness = tier::b,
    .operations = 73,
    .needs = list<&saturate, &to_forward_depth, &exponential_warp>,
    .source = R"GLSL(
// umbrage_encode_evsm4: texel of four components, a growing power, its square, a negative falling power, its square
// NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_evsm4(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec2 exponents) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_exponential_warp(d, -exponents.y);
    return vec4(w, w * w, n, n * n);
}
)GLSL",
};

inline constexpr snippet decode_evsm2{
    .name = "decode_evsm2",
    .summary = "mean of EVSM texels of two components to visibility",
    .exactness = tier::c,
    .operations = 229,
    .needs = list<&chebyshev, &to_forward_depth, &saturate, &exponential_warp>,
    .source = R"GLSL(
// umbrage_decode_evsm2: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
UMBRAGE_HIGHP float umbrage_decode_evsm2(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponent);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least_variance = least * least;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr snippet decode_evsm4{
    .name = "decode_evsm4",
    .summary = "mean of EVSM texels of four components to visibility",
    .exactness = tier::c,
    .operations = 229,
    .needs = list<&chebyshev, &to_forward_depth, &saturate, &exponential_warp>,
    .source = R"GLSL(
// umbrage_decode_evsm4: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
UMBRAGE_HIGHP float umbrage_decode_evsm4(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_exponential_warp(d, -exponents.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least_variance = least * least;
    UMBRAGE_HIGHP float a = umbrage_chebyshev(vec2(m.x, m.y), w, least_variance.x);
    UMBRAGE_HIGHP float b = umbrage_chebyshev(vec2(m.z, m.w), n, least_variance.y);
    UMBRAGE_HIGHP float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr const snippet* evsm_snippets[]{&encode_evsm2, &encode_evsm4, &decode_evsm2, &decode_evsm4};

}  // namespace glsl
}  // namespace umbrage
