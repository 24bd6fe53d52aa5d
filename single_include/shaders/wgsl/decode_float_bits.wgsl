// umbrage 0.1.0, decode_float_bits: four channels, R least significant, to the float they hold. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of float_bits: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (0, 0, 128, 63) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_float_bits.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}

// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
fn umbrage_decode_float_bits(c: vec4f) -> f32 {
    let r: u32 = u32(umbrage_saturate(c.x) * 255.0 + 0.5);
    let g: u32 = u32(umbrage_saturate(c.y) * 255.0 + 0.5);
    let b: u32 = u32(umbrage_saturate(c.z) * 255.0 + 0.5);
    let a: u32 = u32(umbrage_saturate(c.w) * 255.0 + 0.5);
    return bitcast<f32>(r | (g << 8) | (b << 16) | (a << 24));
}
