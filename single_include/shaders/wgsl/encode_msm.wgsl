// umbrage 0.1.0, MIT License: encode_msm
// Paste along: cleared_depth.wgsl, saturate.wgsl, forward_depth.wgsl

// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
fn umbrage_encode_msm(depth: f32) -> vec4f {
    let z: f32 = umbrage_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    let square: f32 = z * z;
    return vec4f(z, square, square * z, square * square);
}
