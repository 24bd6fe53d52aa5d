// umbrage 0.1.0, MIT License: warp_depth
// Paste along: power_of_two.wgsl, exp2_polynomial.wgsl

// umbrage_warp_depth: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_warp_depth(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
