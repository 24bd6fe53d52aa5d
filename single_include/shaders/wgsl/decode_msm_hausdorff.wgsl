// umbrage 0.1.0, MIT License: decode_msm_hausdorff
// Paste along: bias_moments.wgsl, cleared_depth.wgsl, forward_depth.wgsl, moment_atoms.wgsl, decode_msm.wgsl, hausdorff_share.wgsl

// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
fn umbrage_decode_msm_hausdorff(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let plain: f32 = umbrage_decode_msm(b, receiver, bias);
    let d: f32 = umbrage_forward_depth(receiver);
    let z: f32 = select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0;
    let m: vec4f = umbrage_bias_moments(b, bias);
    let x: f32 = z - m.x;
    let atoms: vec4f = umbrage_moment_atoms(m, x);
    let outside: bool = abs(atoms.x + m.x) > 1.0 || abs(atoms.y + m.x) > 1.0;
    let share: f32 = umbrage_hausdorff_share(m, z);
    var lit: f32 = select(1.0, 1.0 - share, z > -1.0);
    let known: bool = outside && abs(atoms.z + atoms.w) <= 4294967296.0 && abs(lit) <= 4294967296.0;  // what is no NaN
    lit = select(plain, select(0.0, select(1.0, lit, lit < 1.0), lit > 0.0), known);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
