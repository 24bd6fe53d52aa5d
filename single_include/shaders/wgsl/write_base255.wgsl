// umbrage 0.1.0, write_base255: depth to base-255 RGBA of Cesium, Babylon.js, bgfx. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// write_base255, tier B: within 6 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of base255: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_base255.
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

// umbrage_write_base255: base-255 RGBA of a depth, values to write as they are. The store must round
// 1.0 reads back as 0.0. umbrage_encode_base255_repaired has neither fault
fn umbrage_write_base255(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    var e: vec4f = vec4f(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    let c: vec4f = vec4f(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
