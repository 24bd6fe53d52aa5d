// umbrage 0.1.0, MIT License: receiver_ps14

// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
fn umbrage_receiver_ps14(depth: f32) -> f32 {
    return select(depth * 1.00392163, -1.0, depth > 1.0);
}
