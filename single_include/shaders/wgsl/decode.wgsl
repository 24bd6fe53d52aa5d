// umbrage 0.1.0, MIT License: decode

// umbrage_decode: depth of a texel's value
fn umbrage_decode(value: vec4f) -> f32 {
    return value.x;
}
