// umbrage 0.1.0, MIT License: encode_evsm2
// Paste along: cleared_depth.wgsl, saturate.wgsl, forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl, warp_depth.wgsl

// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
fn umbrage_encode_evsm2(depth: f32, exponent: f32) -> vec2f {
    let w: f32 = umbrage_warp_depth(umbrage_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2f(w, w * w);
}
