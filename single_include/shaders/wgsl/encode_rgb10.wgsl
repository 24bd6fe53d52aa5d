// umbrage 0.1.0, encode_rgb10: depth to three 10-bit channels, R most significant. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.
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

// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
fn umbrage_encode_rgb10(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 16384.0));
    let rest: f32 = x - high * 16384.0;
    let middle: f32 = floor(rest * (1.0 / 16.0));
    let low: f32 = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3f(high, middle, low * 64.0);
}
