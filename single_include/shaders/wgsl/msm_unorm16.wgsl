// umbrage 0.1.0, msm_unorm16: visibility from a blurred MSM of optimized moments. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// msm_unorm16, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, map_covers.wgsl, texel.wgsl,
//   fetch_clamped.wgsl, fetch_bilinear.wgsl, bias_moments.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl,
//   moment_atoms.wgsl, decode_msm.wgsl, from_optimized_moments.wgsl; or paste wgsl_joined/msm_unorm16.wgsl alone.

// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
fn umbrage_msm_unorm16(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return select(1.0, lit, compared);
}
