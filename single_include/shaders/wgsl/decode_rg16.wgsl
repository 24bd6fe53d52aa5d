// umbrage 0.1.0, decode_rg16: two 8-bit channels, R the low byte, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rg16: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg16.

// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
fn umbrage_from_unorm(c: f32) -> f32 {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec2f(c: vec2f) -> vec2f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec3f(c: vec3f) -> vec3f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec4f(c: vec4f) -> vec4f {
    return floor(c * 255.0 + 0.5);
}

// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
fn umbrage_decode_rg16(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
