// umbrage 0.1.0, encode_esm: depth to a texel of an exponential shadow map (ESM). Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// encode_esm, tier B: within 36 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// Render target of esm: R32F, not sRGB, no blending, one sample. Clear to umbrage_encode_esm of the far plane's
//   depth.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, saturate.wgsl, to_forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl,
//   exponential_warp.wgsl; or paste wgsl_joined/encode_esm.wgsl alone.

// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
fn umbrage_encode_esm(depth: f32, exponent: f32) -> f32 {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
