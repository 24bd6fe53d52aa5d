// SPDX-License-Identifier: MIT
//
// Unpacking of 11 bits as on the Radeon 8500 (pixel shader 1.4): r / 8 + g on the channels as sampled. The result is
// x / 2040, not x / 2048, so the receiver must be scaled by 256 / 255 too.
//
//     bool lit = umbrage::receiver_ps14(depth) <= umbrage::decode_ps14(sampled);
//
// The same in the numbers of that card, whose registers hold 12 fractional bits between -8 and 8 (s3.12):
//
//     bool lit = umbrage::fixed_ps14(umbrage::receiver_ps14(depth)) <= umbrage::decode_fixed_ps14(sampled);
//
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

#include <umbrage/core/compare.hpp>
#include <umbrage/core/scalar.hpp>

namespace umbrage {

/// Stored depth as the Radeon 8500 computed it.
/// @param c      the two channels of encode_rg<11> as sampled, k / 255
/// @return       x / 2040, in [0, 2047 / 2040]
/// @formula      r / 8 + g
/// @exactness    B, n = 4: one rounded addition
/// @cite         ATI Radeon SDK, ShadowMap sample, 2002: mov_d8 and add in pixel shader 1.4
template <real T>
[[nodiscard]] constexpr T decode_ps14(glm::vec<2, T> c) {
    return c.x * T(0.125) + c.y;
}

/// Receiver depth on the scale of decode_ps14, for less_equal_scaled.
/// @param depth   receiver depth; not clamped
/// @edge          beyond the far plane: -1, so that every texel lights it
/// @formula       depth > 1 ? -1 : depth * 256 / 255
/// @exactness     B, n = 1: one product with the rounded quotient
template <real T>
[[nodiscard]] constexpr T receiver_ps14(T depth) {
    return less_equal::beyond_far_plane(depth) ? T(-1) : depth * T(256.0 / 255.0);
}

/// Number as a register of the Radeon 8500 holds it: the nearest multiple of 1/4096 from -8 to 8 - 1/4096.
/// @param v       any number; halfway between two multiples it becomes the greater one
/// @edge          NaN, and 8 or more: 8 - 1/4096. Below -8: -8
/// @formula       floor(4096 v + 1/2) / 4096, clamped
/// @exactness     A: the remainder above the floor is exact, or farther from 1/2 than its rounding
/// @cite          Direct3D 8: MaxPixelShaderValue is 8 on this card; pixel shader 1.4 in s3.12
template <real T>
[[nodiscard]] T fixed_ps14(T v) {
    constexpr T most = T(32767) / T(4096), least = T(-8);
    const T steps = (!is_nan(v) && v < most ? (v > least ? v : least) : most) * T(4096), below = std::floor(steps);
    return (steps - below < T(0.5) ? below : below + T(1)) * T(1.0 / 4096.0);
}

/// Stored depth as the Radeon 8500 computed it, in its own numbers.
/// @param c       the two channels of encode_rg<11> as sampled, k / 255, each off by up to 4 ulp
/// @return        multiple of 1/4096, within 1/4096 of x / 2040: codes stay distinct and in order
/// @formula       floor(r 4096 / 8) / 4096 + g, r and g by fixed_ps14. The shift by _d8 drops three bits
/// @exactness     A
/// @cite          ATI Radeon SDK, ShadowMap sample, 2002: mov_d8 and add in pixel shader 1.4
template <real T>
[[nodiscard]] T decode_fixed_ps14(glm::vec<2, T> c) {
    return std::floor(fixed_ps14(c.x) * T(512)) * T(1.0 / 4096.0) + fixed_ps14(c.y);
}

namespace glsl {

inline constexpr snippet decode_ps14{
    .name = "decode_ps14",
    .summary = "r / 8 + g as the Radeon 8500 computed it",
    .exactness = tier::b,
    .operations = 4,
    .scaled = true,
    .source = R"GLSL(
// umbrage_decode_ps14: x / 2040 from the channels of an 11-bit code, as sampled. Compare with umbrage_receiver_ps14
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_decode_ps14(UMBRAGE_HIGHP vec2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
)GLSL",
};

inline constexpr snippet receiver_ps14{
    .name = "receiver_ps14",
    .summary = "receiver depth on the scale of decode_ps14",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14. Beyond the far plane every texel lights
// it
UMBRAGE_HIGHP float umbrage_receiver_ps14(UMBRAGE_HIGHP float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
)GLSL",
};

inline constexpr snippet fixed_ps14{
    .name = "fixed_ps14",
    .summary = "number in a register of the Radeon 8500",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
UMBRAGE_HIGHP float umbrage_fixed_ps14(UMBRAGE_HIGHP float v) {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    UMBRAGE_HIGHP float within = v > -8.0 && v < 7.999755859375 ? v : (v < 0.0 ? -8.0 : 7.999755859375);
    UMBRAGE_HIGHP float steps = within * 4096.0;
    UMBRAGE_HIGHP float below = floor(steps);
    return (steps - below < 0.5 ? below : below + 1.0) * 0.000244140625;
}
)GLSL",
};

inline constexpr snippet decode_fixed_ps14{
    .name = "decode_fixed_ps14",
    .summary = "r / 8 + g in the Radeon 8500's fixed point",
    .exactness = tier::a,
    .needs = list<&fixed_ps14>,
    .scaled = true,
    .source = R"GLSL(
// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_decode_fixed_ps14(UMBRAGE_HIGHP vec2 c) {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
)GLSL",
};

inline constexpr const snippet* ps14_snippets[]{&decode_ps14, &receiver_ps14, &fixed_ps14, &decode_fixed_ps14};

}  // namespace glsl
}  // namespace umbrage
