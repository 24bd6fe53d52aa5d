// umbrage 0.1.0, MIT License: encode_evsm4
// Paste along: cleared_depth.wgsl, saturate.wgsl, forward_depth.wgsl, power_of_two.wgsl, exp2_polynomial.wgsl, warp_depth.wgsl

// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
fn umbrage_encode_evsm4(depth: f32, exponents: vec2f) -> vec4f {
    let d: f32 = umbrage_forward_depth(umbrage_saturate(depth));
    let w: f32 = umbrage_warp_depth(d, exponents.x);
    let n: f32 = -umbrage_warp_depth(d, -exponents.y);
    return vec4f(w, w * w, n, n * n);
}
