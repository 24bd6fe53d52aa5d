// umbrage 0.1.0, depth_at: stored depth at a point of the map. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// depth_at, tier C: within 4 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
// Paste along: texel.wgsl, fetch_depth.wgsl; or paste wgsl_joined/depth_at.wgsl alone.

// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(map: texture_2d<f32>, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
