// umbrage 0.1.0, MIT License: decode_deviation_rgba8
// Paste along: decode_deviation.wgsl, from_unorm.wgsl, decode_rg16.wgsl

// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
fn umbrage_decode_deviation_rgba8(c: vec4f) -> vec2f {
    let mean: f32 = umbrage_decode_rg16(vec2f(c.x, c.y), 1.0);
    let deviation: f32 = umbrage_decode_rg16(vec2f(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2f(mean, deviation));
}
