// umbrage 0.1.0, MIT License: decode_rgb24
// Paste along: from_unorm.wgsl

// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
fn umbrage_decode_rgb24(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm_vec3f(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
