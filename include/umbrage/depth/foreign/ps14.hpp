// SPDX-License-Identifier: MIT
//
// Unpacking of 11 bits as on the Radeon 8500 (pixel shader 1.4): r / 8 + g on the channels as sampled. The result is
// x / 2040, not x / 2048, so the receiver must be scaled by 256 / 255 too.
//
//     bool lit = umbrage::receiver_ps14(depth) <= umbrage::decode_ps14(sampled);
//
#pragma once

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

inline constexpr const snippet* ps14_snippets[]{&decode_ps14, &receiver_ps14};

}  // namespace glsl
}  // namespace umbrage
