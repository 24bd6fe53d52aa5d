// SPDX-License-Identifier: MIT
//
// Exponential shadow maps (ESM): each texel stores a power of depth. Texels can be blurred, mipmapped and filtered by
// the sampler.
//
//     const auto esm = umbrage::make_esm({.exponent = 40.0f});  // throws where floats would overflow
//     float texel = umbrage::encode_esm(depth, esm.exponent);
//     float visibility = umbrage::decode_esm(blurred, receiver, esm.exponent);
//
// Visibility is the mean of 2^(2 exponent (depth - receiver)) over the texels, at most 1. A caster nearer by
// 3.3 / exponent lets 1/100 of the light through. One lit texel far behind the receiver outweighs all its casters.
// Also called: ESM, exponential shadow maps (make_esm, encode_esm, decode_esm).
// See also: evsm.hpp, which has less light bleeding.
#pragma once

#include <string_view>

#include <umbrage/core/check.hpp>
#include <umbrage/filter/prefiltered/chebyshev.hpp>
#include <umbrage/filter/prefiltered/exp2.hpp>

namespace umbrage {

/// Float format in which the texels of a prefiltered map are stored.
enum class float_store { half, single };

/// Depth on the scale of exponential shadow maps.
/// @param depth      in [0, 1], growing with distance
/// @param exponent   -63 to 63
/// @return           2^-exponent to 2^exponent
/// @formula          exp2_polynomial(exponent (2 depth - 1))
/// @exactness        B, n = 31: S is exp2_polynomial's with g = |exponent| (2 depth + 1) + |n|
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T exponential_warp(T depth, T exponent) {
    return exp2_polynomial(exponent * (depth * T(2) - T(1)));
}

/// Texel of an exponential shadow map.
/// @param depth      in [0, 1]; clamped
/// @param exponent   0 to 63
/// @param cleared    cleared depth: 1, or 0 where depth is reversed
/// @edge             NaN: 2^exponent, as the far plane and a cleared texel
/// @formula          exponential_warp(to_forward_depth)
/// @exactness        B, n = 36
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T encode_esm(T depth, T exponent, T cleared = T(1)) {
    return exponential_warp(to_forward_depth(saturate(depth, cleared), cleared), exponent);
}

/// Visibility from a mean of texels of an exponential shadow map.
/// @param m          mean of texels
/// @param receiver   receiver depth, with the bias already applied
/// @param exponent   same as for the texels
/// @param cleared    cleared depth: 1, or 0 where depth is reversed
/// @return           visibility in [0, 1], before reduce_light_bleeding: at least the lit fraction, minus 2^-20 (1e-6)
/// @edge             NaN m or receiver: 0. Receiver nearer than 0: as lit as at 0
/// @formula          min(m 2^(-exponent (2 d - 1)), 1), d = to_forward_depth(receiver)
/// @exactness        B, n = 37;  within 2^-20 of exact means of exact powers of the same rounded exponents: two powers,
///                   each off by 1.8e-7 of itself, and their product
/// @cite             Annen et al.: Exponential shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_esm(T m, T receiver, T exponent, T cleared = T(1)) {
    const T d = to_forward_depth(receiver, cleared);
    const T p = m * exponential_warp(d, -exponent);
    const T lit = detail::pick(p < T(1), p, T(1));
    return detail::pick(bool(int(p > T(0)) & int(!is_nan(p)) & int(!is_nan(d))), lit, T(0));
}

/// Settings of exponential shadow maps.
struct esm_settings {
    float exponent = 40.0f;  ///< binary exponent at the far plane; twice it is the C of 2^(C depth)
    float_store store = float_store::single;
};

namespace detail {

/// Refuses an exponent with which texels or their inverses would not be normal numbers.
inline void require_esm(std::string_view function, std::string_view argument, const esm_settings& settings) {
    const bool single = settings.store == float_store::single;
    require(settings.exponent > 0.0f && settings.exponent <= (single ? 63.0f : 14.0f), function, argument,
            single ? "above 0 and at most 63" : "above 0 and at most 14 in 16 bits", settings.exponent,
            "Beyond that the warped depth overflows.");
}

}  // namespace detail

/// Checks the settings.
/// @return   the settings, unchanged
/// @throws std::invalid_argument   exponent not above 0, or above 63 in 32 bits, 14 in 16. Within these limits the
///                                 texels and their inverses are normal numbers
[[nodiscard]] inline esm_settings make_esm(const esm_settings& settings) {
    detail::require_esm("make_esm", "exponent", settings);
    return settings;
}

namespace glsl {

inline constexpr snippet exponential_warp{
    .name = "exponential_warp",
    .summary = "depth on the scale of exponential shadow maps",
    .exactness = tier::b,
    .operations = 31,
    .needs = list<&exp2_polynomial>,
    .source = R"GLSL(
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
UMBRAGE_HIGHP float umbrage_exponential_warp(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
)GLSL",
};

inline constexpr snippet encode_esm{
    .name = "encode_esm",
    .summary = "depth to a texel of an exponential shadow map (ESM)",
    .exactness = tier::b,
    .operations = 36,
    .needs = list<&saturate, &to_forward_depth, &exponential_warp>,
    .source = R"GLSL(
// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
UMBRAGE_HIGHP float umbrage_encode_esm(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
)GLSL",
};

inline constexpr snippet decode_esm{
    .name = "decode_esm",
    .summary = "mean of ESM texels to visibility",
    .exactness = tier::b,
    .operations = 37,
    .needs = list<&to_forward_depth, &exponential_warp>,
    .source = R"GLSL(
// umbrage_decode_esm: visibility of a receiver from an exponential shadow map, at least its lit fraction. 1.0 = lit
//   m          mean of texels
//   receiver   receiver depth, bias applied
//   exponent   same as for the texels
UMBRAGE_HIGHP float umbrage_decode_esm(UMBRAGE_HIGHP float m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP float p = m * umbrage_exponential_warp(d, -exponent);
    UMBRAGE_HIGHP float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr const snippet* esm_snippets[]{&exponential_warp, &encode_esm, &decode_esm};

}  // namespace glsl
}  // namespace umbrage
