// umbrage 0.1.0, pcf_2x2_dx_sdk: bilinear 2x2 PCF of the DirectX SDK sample, plain floats. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// pcf_2x2_dx_sdk, tier B: within 20 x 2^-23 x S of the exact result.
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
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: compare_dx_sdk.wgsl, inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl,
//   texel.wgsl, fetch_depth.wgsl; or paste wgsl_joined/pcf_2x2_dx_sdk.wgsl alone.

// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
fn umbrage_pcf_2x2_dx_sdk(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, epsilon: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x);
    let weight: vec2f = x - texel;
    let a: f32 = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    let right: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 0.0));
    let above: f32 = umbrage_fetch_depth(map, size, texel + vec2f(0.0, 1.0));
    let beyond: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 1.0));
    let b: f32 = umbrage_compare_dx_sdk(receiver, right, epsilon);
    let c: f32 = umbrage_compare_dx_sdk(receiver, above, epsilon);
    let d: f32 = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    let low: f32 = a + weight.x * (b - a);
    let high: f32 = c + weight.x * (d - c);
    let visibility: f32 = low + weight.y * (high - low);
    return select(1.0, visibility, compared);
}
