// umbrage 0.1.0, MIT License: decode_rg11
// Paste along: from_unorm.wgsl

// umbrage_decode_rg11: two channels of a 11-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, centre, upper edge of the code's interval
fn umbrage_decode_rg11(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
