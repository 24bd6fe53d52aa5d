// umbrage 0.1.0, write_threejs_rg: depth to three.js RG, r167 and later. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// write_threejs_rg, tier B: within 1 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rg: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed
//   depth to (0, 0) / 255. Write umbrage_write_threejs_rg.
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

// umbrage_write_threejs_rg: RG of a depth, as in three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rg(depth: f32) -> vec2f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 256.0;
    let whole: f32 = floor(x);
    return select(vec2f(1.0, 1.0), vec2f(whole * 0.00392156886, x - whole), v < 1.0);
}
