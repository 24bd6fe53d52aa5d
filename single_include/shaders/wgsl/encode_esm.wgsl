// umbrage 0.1.0, MIT License: encode_esm
// Paste along: cleared_depth.wgsl, saturate.wgsl, forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl, warp_depth.wgsl

// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
fn umbrage_encode_esm(depth: f32, exponent: f32) -> f32 {
    return umbrage_warp_depth(umbrage_forward_depth(umbrage_saturate(depth)), exponent);
}
