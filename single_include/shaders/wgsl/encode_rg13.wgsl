// umbrage 0.1.0, encode_rg13: depth to two 8-bit channels, R the low byte. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rg13: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 248) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg13.
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

// umbrage_encode_rg13: two channels of a 13-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rg13(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 8.0);
}
