// umbrage 0.1.0, encode_esm: depth to a texel of an exponential shadow map (ESM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_esm, tier B: within 36 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of esm: R32F, not sRGB, no blending, one sample. Clear to umbrage_encode_esm of the far plane's
//   depth.
// Other maps: bind() of the library or of its npm package prints this text, by direction.

// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}

// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
fn umbrage_exp2_polynomial(y: f32) -> f32 {
    let x: f32 = select(-64.0, min(y, 63.0), y > -64.0);
    let n: f32 = floor(x);
    let f: f32 = x - n;
    var p: f32 = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}

// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_exponential_warp(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}

// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}

// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
fn umbrage_encode_esm(depth: f32, exponent: f32) -> f32 {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
