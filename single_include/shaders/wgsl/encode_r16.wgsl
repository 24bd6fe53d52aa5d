// umbrage 0.1.0, encode_r16: depth to one 16-bit channel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of r16: R16 UNORM, not sRGB, no blending, one sample. Clear to (65535) / 65535, with reversed depth
//   to (0) / 65535. Write umbrage_to_unorm16 of umbrage_encode_r16.
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

// umbrage_encode_r16: 16-bit channel of a depth, an integer 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_r16(depth: f32) -> f32 {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
