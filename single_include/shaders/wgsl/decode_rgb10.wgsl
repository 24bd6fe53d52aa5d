// umbrage 0.1.0, decode_rgb10: three 10-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.
// Paste along: from_unorm10.wgsl; or paste wgsl_joined/decode_rgb10.wgsl alone.

// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
fn umbrage_decode_rgb10(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm10_vec3f(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
