// umbrage 0.1.0, MIT License: decode_vsm
// Paste along: chebyshev.wgsl, cleared_depth.wgsl, forward_depth.wgsl

// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_forward_depth(receiver), min_variance);
}
