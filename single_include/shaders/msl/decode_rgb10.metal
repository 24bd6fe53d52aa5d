// umbrage 0.1.0, decode_rgb10: three 10-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_FROM_UNORM10
#define UMBRAGE_HAS_FROM_UNORM10
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
inline float umbrage_from_unorm10(float c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float2 umbrage_from_unorm10(float2 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float3 umbrage_from_unorm10(float3 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float4 umbrage_from_unorm10(float4 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RGB10
#define UMBRAGE_HAS_DECODE_RGB10
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
inline float umbrage_decode_rgb10(float3 c, float edge) {
    float3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + metal::floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
#endif
