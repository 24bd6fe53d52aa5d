// umbrage 0.1.0, MIT License: decode_threejs_rg

// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rg(c: vec2f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
