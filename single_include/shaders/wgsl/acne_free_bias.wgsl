// umbrage 0.1.0, MIT License: acne_free_bias
// Paste along: clamp_bias.wgsl

// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
fn umbrage_acne_free_bias(slope: vec2f, reach: f32, error: f32) -> f32 {
    let bias: f32 = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
