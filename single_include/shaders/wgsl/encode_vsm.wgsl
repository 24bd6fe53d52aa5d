// umbrage 0.1.0, encode_vsm: depth to a texel of a variance shadow map (VSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_vsm, tier B: within 3 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
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

// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}

// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
fn umbrage_encode_vsm(depth: f32) -> vec2f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2f(d, d * d);
}
