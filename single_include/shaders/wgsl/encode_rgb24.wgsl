// umbrage 0.1.0, MIT License: encode_rgb24
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rgb24(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    return vec3f(high, middle, rest - middle * 256.0);
}
