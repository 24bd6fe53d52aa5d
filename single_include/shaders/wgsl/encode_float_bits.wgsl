// umbrage 0.1.0, MIT License: encode_float_bits

// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
fn umbrage_encode_float_bits(v: f32) -> vec4f {
    let bits: u32 = bitcast<u32>(v);
    return vec4f(f32(bits & 255u), f32((bits >> 8) & 255u), f32((bits >> 16) & 255u), f32(bits >> 24));
}
