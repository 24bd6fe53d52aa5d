// umbrage 0.1.0, decode_evsm2: mean of EVSM texels of two components to visibility. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_evsm2, tier C: within 229 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: chebyshev.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl, saturate.wgsl, power_of_two.wgsl,
//   exp2_polynomial.wgsl, exponential_warp.wgsl; or paste wgsl_joined/decode_evsm2.wgsl alone.

// umbrage_decode_evsm2: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
fn umbrage_decode_evsm2(m: vec2f, receiver: f32, exponent: f32, deviation: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(receiver));
    let w: f32 = umbrage_exponential_warp(d, exponent);
    let least: f32 = deviation * w;
    let least_variance: f32 = least * least;
    let lit: f32 = umbrage_chebyshev(m, w, least_variance);
    return select(select(0.0, lit, receiver <= 0.0), lit, receiver > 0.0);
}
