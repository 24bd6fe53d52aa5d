// umbrage 0.1.0, MIT License: encode_rg14
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_encode_rg14: depth to the two channels of a 14-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg14(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 4.0);
}
