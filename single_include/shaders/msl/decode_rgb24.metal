// umbrage 0.1.0, decode_rgb24: three 8-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb24: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rgb24.

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

#ifndef UMBRAGE_HAS_DECODE_RGB24
#define UMBRAGE_HAS_DECODE_RGB24
// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
inline float umbrage_decode_rgb24(float3 c, float edge) {
    float3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
#endif
