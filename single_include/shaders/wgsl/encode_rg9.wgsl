// umbrage 0.1.0, MIT License: encode_rg9
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_encode_rg9: depth to the two channels of a 9-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg9(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 128.0);
}
