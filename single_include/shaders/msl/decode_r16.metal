// umbrage 0.1.0, decode_r16: one 16-bit channel to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of r16: R16 UNORM, not sRGB, no blending, one sample. Clear to (65535) / 65535, with reversed depth
//   to (0) / 65535. Write umbrage_to_unorm16 of umbrage_encode_r16.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FROM_UNORM16
#define UMBRAGE_HAS_FROM_UNORM16
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
inline float umbrage_from_unorm16(float c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float2 umbrage_from_unorm16(float2 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float3 umbrage_from_unorm16(float3 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float4 umbrage_from_unorm16(float4 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_R16
#define UMBRAGE_HAS_DECODE_R16
// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_r16(float c, float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
#endif
