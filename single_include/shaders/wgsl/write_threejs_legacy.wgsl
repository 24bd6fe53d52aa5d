// umbrage 0.1.0, write_threejs_legacy: depth to three.js RGBA, r73 to r166. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// write_threejs_legacy, tier B: within 7 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_legacy: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) /
//   255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_legacy.
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

// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
fn umbrage_write_threejs_legacy(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0 - floor(v * 16777216.0);
    let y: f32 = v * 65536.0 - floor(v * 65536.0);
    let z: f32 = v * 256.0 - floor(v * 256.0);
    let c: vec4f = vec4f(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
