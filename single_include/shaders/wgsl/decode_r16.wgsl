// umbrage 0.1.0, decode_r16: one 16-bit channel to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of r16: R16 UNORM, not sRGB, no blending, one sample. Clear to (65535) / 65535, with reversed depth
//   to (0) / 65535. Write umbrage_to_unorm16 of umbrage_encode_r16.

// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
fn umbrage_from_unorm16(c: f32) -> f32 {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec2f(c: vec2f) -> vec2f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec3f(c: vec3f) -> vec3f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec4f(c: vec4f) -> vec4f {
    return floor(c * 65535.0 + 0.5);
}

// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_r16(c: f32, edge: f32) -> f32 {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
