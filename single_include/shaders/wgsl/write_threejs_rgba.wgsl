// umbrage 0.1.0, write_threejs_rgba: depth to three.js RGBA, r167 and later. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// write_threejs_rgba, tier B: within 5 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_rgba: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_rgba.
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

// umbrage_write_threejs_rgba: RGBA of a depth, as in three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgba(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 65536.0));
    let rest: f32 = whole - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = rest - middle * 256.0;
    let c: vec4f = vec4f(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return select(vec4f(1.0, 1.0, 1.0, 1.0), c, v < 1.0);
}
