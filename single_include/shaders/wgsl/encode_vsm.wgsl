// umbrage 0.1.0, MIT License: encode_vsm
// Paste along: cleared_depth.wgsl, saturate.wgsl, forward_depth.wgsl

// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
fn umbrage_encode_vsm(depth: f32) -> vec2f {
    let d: f32 = umbrage_forward_depth(umbrage_saturate(depth));
    return vec2f(d, d * d);
}
