// umbrage 0.1.0, MIT License: decode_threejs_rgba

// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rgba(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
