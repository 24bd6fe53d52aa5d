// umbrage 0.1.0, four_tap: mean of four taps, each with its own coordinates. Exactness: tier A.
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
// Paste along: compare.wgsl, texel.wgsl, fetch_depth.wgsl, lit.wgsl, beyond_far_plane.wgsl; or paste
//   wgsl_joined/four_tap.wgsl alone.

// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
fn umbrage_four_tap(map: texture_2d<f32>, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f, receiver: f32) -> f32 {
    let a_texel: vec2f = floor(a);
    let b_texel: vec2f = floor(b);
    let c_texel: vec2f = floor(c);
    let d_texel: vec2f = floor(d);
    let sum: vec2f = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    let compared: bool = select(sum.x < 131072.0 && sum.y * 2.0 < 262144.0, false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return select(1.0, count * 0.25, compared);
}
