// umbrage 0.1.0, MIT License: slope_bias
// Paste along: clamp_bias.wgsl

// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
fn umbrage_slope_bias(slope: vec2f, factor: f32, base: f32) -> f32 {
    let bias: vec2f = abs(slope) * factor + base;
    let x: f32 = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    let y: f32 = umbrage_clamp_bias(bias.y);
    return select(y, x, x > y);
}
