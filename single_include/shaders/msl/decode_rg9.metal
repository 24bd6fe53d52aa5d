// umbrage 0.1.0, decode_rg9: two 8-bit channels, R the low byte, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rg9: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 128) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg9.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
inline float umbrage_from_unorm(float c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float2 umbrage_from_unorm(float2 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float3 umbrage_from_unorm(float3 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float4 umbrage_from_unorm(float4 c) {
    return metal::floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG9
#define UMBRAGE_HAS_DECODE_RG9
// umbrage_decode_rg9: depth from the two channels of a 9-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
inline float umbrage_decode_rg9(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
#endif
