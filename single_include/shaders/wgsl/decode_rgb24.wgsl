// umbrage 0.1.0, decode_rgb24: three 8-bit channels, R most significant, to depth. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb24: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rgb24.
// Paste along: from_unorm.wgsl; or paste wgsl_joined/decode_rgb24.wgsl alone.

// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
fn umbrage_decode_rgb24(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm_vec3f(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
