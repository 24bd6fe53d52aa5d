// umbrage 0.1.0, MIT License: decode_base255

// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
fn umbrage_decode_base255(c: vec4f) -> f32 {
    let depth: f32 = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
