// umbrage 0.1.0, to_unorm10: value that makes a 10-bit target store channel 0..1023. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_TO_UNORM10
#define UMBRAGE_HAS_TO_UNORM10
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
inline float umbrage_to_unorm10(float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float2 umbrage_to_unorm10(float2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float3 umbrage_to_unorm10(float3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float4 umbrage_to_unorm10(float4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
#endif
