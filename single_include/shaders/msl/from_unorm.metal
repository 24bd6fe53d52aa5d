// umbrage 0.1.0, from_unorm: channel 0..255 of a value from an 8-bit texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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
