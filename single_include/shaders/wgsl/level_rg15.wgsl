// umbrage 0.1.0, MIT License: level_rg15

// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
fn umbrage_level_rg15(c: vec2f) -> f32 {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
