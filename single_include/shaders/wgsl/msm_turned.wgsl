// umbrage 0.1.0, msm_turned: visibility from a map of turned moments. Exactness: tier C.
// Tier C: WGSL lets compilers fuse or reorder sums. Results then stay within the stated bound.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Map: `map: texture_2d<f32>`, texels of the kind that the function's comment names, read unfiltered.
// Render target of msm_turned: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to umbrage_turn_moments of
//   umbrage_encode_msm of the far plane's depth.
// Paste along: inside_texel_space.wgsl, beyond_far.wgsl, is_compared.wgsl, texel.wgsl, fetch_clamped.wgsl,
//   fetch_bilinear.wgsl, bias_moments.wgsl, cleared_depth.wgsl, forward_depth.wgsl, moment_atoms.wgsl,
//   decode_msm.wgsl, turn_moments_back.wgsl; or paste wgsl_joined/msm_turned.wgsl alone.

// umbrage_msm_turned: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
fn umbrage_msm_turned(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = umbrage_is_compared(coord, receiver);
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(umbrage_turn_moments_back(m), receiver, bias);
    return select(1.0, lit, compared);
}
