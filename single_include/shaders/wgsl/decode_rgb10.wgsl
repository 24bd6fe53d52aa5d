// umbrage 0.1.0, decode_rgb10: three 10-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.

// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
fn umbrage_from_unorm10(c: f32) -> f32 {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec2f(c: vec2f) -> vec2f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec3f(c: vec3f) -> vec3f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec4f(c: vec4f) -> vec4f {
    return floor(c * 1023.0 + 0.5);
}

// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
fn umbrage_decode_rgb10(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm10_vec3f(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
