// umbrage 0.1.0, pcf_2x2: bilinear 2x2 PCF, weights in steps of 1/256. Exactness: tier A.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: pcf_2x2_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, compare.wgsl, texel.wgsl,
//   fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl; or paste wgsl_joined/pcf_2x2.wgsl alone.

// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    let lit: vec4f = umbrage_lit_2x2(map, size, texel, receiver);
    let visibility: f32 = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return select(1.0, visibility, compared);
}
