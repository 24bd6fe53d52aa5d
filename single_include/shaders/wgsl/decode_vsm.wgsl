// umbrage 0.1.0, decode_vsm: mean of VSM texels to visibility. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_vsm, tier C: within 13 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: chebyshev.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl; or paste wgsl_joined/decode_vsm.wgsl alone.

// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
