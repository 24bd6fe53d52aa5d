// umbrage 0.1.0, MIT License: decode_threejs_rgb

// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rgb(c: vec3f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
