// umbrage 0.1.0, encode_base255_repaired: depth to base-255 RGBA without its faults. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_base255_repaired, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of base255_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_base255_repaired.
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

// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_base255_repaired(depth: f32) -> vec4f {
    let x: f32 = umbrage_saturate(depth) * 255.0;
    let y: f32 = (x - floor(x)) * 255.0;
    let z: f32 = (y - floor(y)) * 255.0;
    let w: f32 = (z - floor(z)) * 255.0;
    return vec4f(floor(x), floor(y), floor(z), floor(w));
}
