// umbrage 0.1.0, lit_filtered: weighted comparisons around a point in texels. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// lit_filtered, tier C: within 1/128 of C++.
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
//   fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, pcf_2x2.wgsl; or paste wgsl_joined/lit_filtered.wgsl alone.

// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
fn umbrage_lit_filtered(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2f(-32767.0, -32767.0), vec2f(32767.0, 32767.0)), receiver);
}
