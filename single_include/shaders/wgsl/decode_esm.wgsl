// umbrage 0.1.0, decode_esm: mean of ESM texels to visibility. Exactness: tier B.
// WGSL lets compilers fuse or reorder sums.
// decode_esm, tier B: within 37 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: cleared_depth.wgsl, to_forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl,
//   exponential_warp.wgsl; or paste wgsl_joined/decode_esm.wgsl alone.

// umbrage_decode_esm: visibility of a receiver from an exponential shadow map, at least its lit fraction. 1.0 = lit
//   m          mean of texels
//   receiver   receiver depth, bias applied
//   exponent   same as for the texels
fn umbrage_decode_esm(m: f32, receiver: f32, exponent: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let p: f32 = m * umbrage_exponential_warp(d, -exponent);
    let lit: f32 = select(select(0.0, 1.0, p >= 1.0), p, p > 0.0 && p < 1.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
