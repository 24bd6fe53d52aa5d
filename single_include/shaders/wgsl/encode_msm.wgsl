// umbrage 0.1.0, encode_msm: depth to a texel of a moment shadow map (MSM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_msm, tier B: within 15 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of msm: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_msm of the far plane's
//   depth.
// Render target of msm_hausdorff: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_msm of the far
//   plane's depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, saturate.wgsl, to_forward_depth.wgsl; or paste wgsl_joined/encode_msm.wgsl alone.

// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, the texel of a moment shadow map. NaN counts as far
fn umbrage_encode_msm(depth: f32) -> vec4f {
    let z: f32 = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    let square: f32 = z * z;
    return vec4f(z, square, square * z, square * square);
}
