// umbrage 0.1.0, pcf_2x2_hardware: bilinear 2x2 PCF by a linear comparison sampler. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// pcf_2x2_hardware, tier C: within 1/128 of C++.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered. For a comparison
//   sampler: pcf_2x2_hardware_shadow.
// Render target of the map: depth attachment, or R32F, not sRGB, no blending, one sample. Clear to 1.0, with reversed
//   depth to 0.0.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   depth      depth of a texel's value, in place of .x: for packed depths
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   compare    one comparison, in place of receiver <= stored
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, within_far_plane.wgsl,
//   compare.wgsl, texel.wgsl, fetch_depth.wgsl, lit.wgsl, lit_2x2.wgsl, pcf_2x2.wgsl, lit_filtered.wgsl, lit_at.wgsl;
//   or paste wgsl_joined/pcf_2x2_hardware.wgsl alone.

// umbrage_pcf_2x2_hardware: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
fn umbrage_pcf_2x2_hardware(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), coord, compared);
    let lit: f32 = umbrage_lit_at(map, size, at / size, receiver);
    let visibility: f32 = select(0.0, lit, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
