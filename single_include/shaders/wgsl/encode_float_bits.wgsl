// umbrage 0.1.0, encode_float_bits: bit pattern of a float to four channels, R least significant. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of float_bits: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (0, 0, 128, 63) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_float_bits.

// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
fn umbrage_encode_float_bits(v: f32) -> vec4f {
    let bits: u32 = bitcast<u32>(v);
    return vec4f(f32(bits & 255u), f32((bits >> 8) & 255u), f32((bits >> 16) & 255u), f32(bits >> 24));
}
