// umbrage 0.1.0, decode_msm_hausdorff: mean of MSM texels to visibility, for depths on [-1, 1]. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_msm_hausdorff, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: bias_moments.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl, moment_atoms.wgsl, decode_msm.wgsl,
//   hausdorff_share.wgsl; or paste wgsl_joined/decode_msm_hausdorff.wgsl alone.

// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
fn umbrage_decode_msm_hausdorff(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let plain: f32 = umbrage_decode_msm(b, receiver, bias);
    let d: f32 = umbrage_to_forward_depth(receiver);
    let z: f32 = select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0;
    let share: f32 = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    let lit: f32 = select(plain, 1.0 - share, share >= 0.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
