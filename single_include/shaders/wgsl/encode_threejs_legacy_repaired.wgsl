// umbrage 0.1.0, encode_threejs_legacy_repaired: depth to three.js RGBA, r73 to r166, without its fault. Exactness:
//   tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of threejs_legacy_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255,
//   255) / 255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of
//   umbrage_encode_threejs_legacy_repaired.
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

// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_threejs_legacy_repaired(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = floor(v * 16777216.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return select(vec4f(255.0, 255.0, 255.0, 255.0), vec4f(0.0, low, middle, high), v < 1.0);
}
