// umbrage 0.1.0, box: lit fraction of a box of radius 0..8 (box PCF). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// box, tier B: within 290 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: box_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, compare.wgsl, texel.wgsl,
//   fetch_depth.wgsl, lit.wgsl, box_count.wgsl, box_scale.wgsl; or paste wgsl_joined/box.wgsl alone.

// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
fn umbrage_box(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let visibility: f32 = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return select(1.0, visibility, visibility < 0.999);  // 121 times the rounded 1/121 is not 1
}
