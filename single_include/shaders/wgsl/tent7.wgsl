// umbrage 0.1.0, tent7: PCF kernel 1 2 3 4 3 2 1. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, compare.wgsl, texel.wgsl,
//   fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, window_sum7.wgsl; or paste wgsl_joined/tent7.wgsl alone.

// umbrage_tent7: PCF under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_tent7(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
