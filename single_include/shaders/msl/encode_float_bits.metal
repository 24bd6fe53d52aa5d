// umbrage 0.1.0, encode_float_bits: bit pattern of a float to four channels, R least significant. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of float_bits: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (0, 0, 128, 63) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_float_bits.

#include <metal_stdlib>
#pragma METAL fp math_mode(safe)
#pragma METAL fp contract(off)

#ifndef UMBRAGE_HAS_ENCODE_FLOAT_BITS
#define UMBRAGE_HAS_ENCODE_FLOAT_BITS
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
inline float4 umbrage_encode_float_bits(float v) {
    uint bits = as_type<uint>(v);
    return float4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
#endif
