// umbrage 0.1.0, from_unorm10: channel 0..1023 of a value from a 10-bit texture. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

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
