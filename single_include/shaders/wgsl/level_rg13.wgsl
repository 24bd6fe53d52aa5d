// umbrage 0.1.0, MIT License: level_rg13

// umbrage_level_rg13: two channels of a 13-bit code, as sampled, to the scale of umbrage_receiver_rg13, on which 1.0 is
//   not the far plane
fn umbrage_level_rg13(c: vec2f) -> f32 {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
