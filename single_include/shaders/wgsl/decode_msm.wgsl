// umbrage 0.1.0, decode_msm: mean of MSM texels to visibility. Exactness: tier C.
// WGSL lets compilers fuse or reorder sums.
// decode_msm, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
// For other maps, bind() of the library or of its npm package prints this text, with
//   direction  reversed: depth is 1.0 at the near plane and 0.0 at the far plane
// Paste along: bias_moments.wgsl, cleared_depth.wgsl, to_forward_depth.wgsl, moment_atoms.wgsl; or paste
//   wgsl_joined/decode_msm.wgsl alone.

// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
fn umbrage_decode_msm(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let m: vec4f = umbrage_bias_moments(b, bias);
    let x: f32 = (select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0) - m.x;
    let atoms: vec4f = umbrage_moment_atoms(m, x);
    let first: f32 = select(0.0, atoms.z, atoms.x < x);
    let second: f32 = select(0.0, atoms.w, atoms.y < x);
    var lit: f32 = 1.0 - (first + second);
    let known: bool = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = select(select(0.0, 1.0, x <= 0.0), select(0.0, select(1.0, lit, lit < 1.0), lit > 0.0), known);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
