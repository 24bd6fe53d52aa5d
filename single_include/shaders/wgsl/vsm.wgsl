// umbrage 0.1.0, vsm: visibility from a blurred variance shadow map (VSM). Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// vsm, tier C: within 165 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   texture    array, atlas, cube, shadow, ...; parameters, arguments and texel take any other
//   outside    clamped: outside the map the nearest texel inside counts; without it all is lit there
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: inside_texel_space.wgsl, beyond_far_plane.wgsl, in_filter_domain.wgsl, map_covers.wgsl, texel.wgsl,
//   fetch_clamped.wgsl, fetch_bilinear.wgsl, chebyshev.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl,
//   decode_vsm.wgsl; or paste wgsl_joined/vsm.wgsl alone.

// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
fn umbrage_vsm(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_vsm(vec2f(m.x, m.y), receiver, min_variance);
    return select(1.0, lit, compared);
}
