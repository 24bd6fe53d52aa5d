// umbrage 0.1.0, MIT License: encode_threejs_legacy_repaired
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_threejs_legacy_repaired(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = floor(v * 16777216.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    return select(vec4f(255.0, 255.0, 255.0, 255.0), vec4f(0.0, rest - middle * 256.0, middle, high), v < 1.0);
}
