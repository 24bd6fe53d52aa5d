// umbrage 0.1.0, lit: one comparison with a texel. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// Outside the map all is lit. For the nearest texel inside instead: bind() with outside clamped.
// Paste along: compare.wgsl, texel.wgsl, decode.wgsl, cleared_depth.wgsl, border_depth.wgsl, fetch_depth.wgsl; or
//   paste wgsl_joined/lit.wgsl alone.

// umbrage_lit: visibility of one comparison with a texel
fn umbrage_lit(map: texture_2d<f32>, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
