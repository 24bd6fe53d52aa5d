// umbrage 0.1.0, MIT License: decode_float_bits
// Paste along: cleared_depth.wgsl, saturate.wgsl

// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
fn umbrage_decode_float_bits(c: vec4f) -> f32 {
    let r: u32 = u32(umbrage_saturate(c.x) * 255.0 + 0.5);
    let g: u32 = u32(umbrage_saturate(c.y) * 255.0 + 0.5);
    let b: u32 = u32(umbrage_saturate(c.z) * 255.0 + 0.5);
    let a: u32 = u32(umbrage_saturate(c.w) * 255.0 + 0.5);
    return bitcast<f32>(r | (g << 8) | (b << 16) | (a << 24));
}
